// built from web/, sources sha256:975faf8eb969c5273c682b1f9638db58d79ceb8961db827b87d95029247ec21c
"use strict";var heli=(()=>{var Xu=Object.defineProperty;var Sx=Object.getOwnPropertyDescriptor;var wx=Object.getOwnPropertyNames;var Tx=Object.prototype.hasOwnProperty;var Ex=(i,e)=>{for(var t in e)Xu(i,t,{get:e[t],enumerable:!0})},Ax=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of wx(e))!Tx.call(i,s)&&s!==t&&Xu(i,s,{get:()=>e[s],enumerable:!(n=Sx(e,s))||n.enumerable});return i};var Rx=i=>Ax(Xu({},"__esModule",{value:!0}),i);var G1={};Ex(G1,{Flight:()=>oa,KalmanController:()=>Qo,ResidualController:()=>ta,actions:()=>up,advance:()=>ra,atRest:()=>sa,basis:()=>rh,clip:()=>ui,controlGrid:()=>ea,controllersAlong:()=>mh,coriolis:()=>Kf,drawn:()=>Kr,dynamics:()=>On,fanThrusts:()=>Ju,feedforward:()=>Jr,footForce:()=>Yu,friction:()=>fl,generalisedForces:()=>Qf,gravity:()=>jf,hoverInput:()=>Di,hoverTracking:()=>ch,inputAt:()=>ii,integratePlan:()=>xh,internalDynamics:()=>sh,inverseDynamics:()=>Fs,kalmanLqrGains:()=>uh,linearise:()=>Os,massMatrix:()=>Jf,measurement:()=>gh,modelOf:()=>mp,powerThrust:()=>Zu,prepared:()=>ia,quantise:()=>ih,riccatiGains:()=>na,rigidDynamics:()=>Qu,rk4Step:()=>Si,solveSymmetric:()=>ep,solve_2x2:()=>Ku,splinePlan:()=>_h,thrust:()=>$u,thrustAt:()=>pl,thrustBounds:()=>Zr,thrustVector:()=>ju,thrusts:()=>ni,trackingController:()=>lh,unpacked:()=>dh,virtualInput:()=>jo,voltageFor:()=>ml,voltages:()=>hi,withContact:()=>nh,withFrictionAndDisturbances:()=>eh,withLift:()=>th,withStationaryCost:()=>fh});function jt(i,e,t=""){let n=document.createElementNS("http://www.w3.org/2000/svg",i);for(let[s,r]of Object.entries(e))n.setAttribute(s,String(r));return n.textContent=t,n}var cl=i=>i.map(([e,t])=>`${e.toFixed(1)},${t.toFixed(1)}`).join(" ");var qf=["M-0.9,0 A0.9,0.9 0 1 0 0.9,0 A0.9,0.9 0 1 0 -0.9,0 Z","M-0.8,-0.8 H0.8 V0.8 H-0.8 Z","M0,-1 L0.95,0.75 H-0.95 Z","M0,-1.1 L1.1,0 L0,1.1 L-1.1,0 Z","M0,1 L0.95,-0.75 H-0.95 Z","M-0.35,-1 H0.35 V-0.35 H1 V0.35 H0.35 V1 H-0.35 V0.35 H-1 V-0.35 H-0.35 Z"],Yf=[[],[9,3],[2,3],[9,3,2,3],[5,3],[12,4,2,4,2,4]],Zo=i=>qf[i%qf.length],$f=i=>Yf[i%Yf.length];function ei(i,e,t=""){let s=jt("svg",{viewBox:"-1.3 -1.3 2.6 2.6",class:"swatch",...t?{role:"img","aria-label":t}:{"aria-hidden":"true"}});return s.append(jt("path",{d:Zo(i),fill:e})),s}function J(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))typeof r=="function"?n.addEventListener(s,r):typeof r=="boolean"?n.toggleAttribute(s,r):n.setAttribute(s,String(r));return n.append(...t),n}var Vt=i=>i*180/Math.PI,hr=i=>i*Math.PI/180,Pn=(i,e)=>i.toFixed(e).replace(/^-(?=.*[1-9])/,"\u2212").replace(/^-/,"");function ci(i){return getComputedStyle(document.documentElement).getPropertyValue(`--${i}`).trim()}function Us(i){for(let e of["(prefers-color-scheme: dark)","print"])matchMedia(e).addEventListener("change",i)}function ul(i){let e=i.target;return i.ctrlKey||i.metaKey||i.altKey||e.matches("select, textarea, input[type=text]")?!0:e.matches("input[type=range], input[type=radio], [role=slider], [role=application], .scroll")?/^(Arrow|Home|End|Page|[-+=0])/.test(i.key):e.matches("button, summary, a, input")&&[" ","Enter"].includes(i.key)}function hl(i){let e=i.flatMap(([t,n])=>[J("dt",{},...t.split(" ").map(s=>J("kbd",{},s))),J("dd",{},n)]);return J("details",{class:"help"},J("summary",{},"Keyboard"),J("dl",{},...e))}function Zf(i,e){let t=J("div",{class:"scroll",tabindex:0,role:"region","aria-label":i},e),n=J("p",{class:"small hint",hidden:!0},"Scroll sideways for all columns \u2192");return new ResizeObserver(()=>n.hidden=t.scrollWidth<=t.clientWidth+1).observe(t),J("div",{},n,t)}var Yr=class{element=J("span",{class:"meter"});frames=0;busy=0;since=performance.now();measure(e){let t=performance.now();e(),queueMicrotask(()=>this.count(t))}count(e){let t=performance.now();if(this.busy+=t-e,this.frames+=1,t-this.since>=1e3){let n=1e3*this.frames/(t-this.since),s=this.busy/this.frames;this.element.textContent=`${n.toFixed(0)} frames/s, ${s.toFixed(1)} ms of script each`,Object.assign(this.element.dataset,{rate:n,script:s}),[this.frames,this.busy,this.since]=[0,0,t]}}},$r=class{element;numbers=["travel","elevation","pitch","front","back"].map(e=>J("span",{title:e}));note=J("div",{class:"note"});constructor(e,t,n){let s=J("div",{class:"name"},ei(n,t),e);this.element=J("div",{class:"view"},s,this.note,J("div",{class:"numbers"},...this.numbers))}show(e,t,n){[e[0],e[2],e[4]].forEach((s,r)=>this.write(r,`${Pn(Vt(s),1)}\xB0`)),t.forEach((s,r)=>this.write(3+r,`${Pn(s,1)} V`)),this.note.textContent=n,this.note.hidden=n===""}write(e,t){let n=`${this.numbers[e].title} ${t}`;this.numbers[e].textContent!==n&&(this.numbers[e].textContent=n)}};var ti=i=>i[0].map((e,t)=>i.map(n=>n[t]));function dr(i,e){return i.map(t=>{let n=0;for(let s=0;s<t.length;s++)n+=t[s]*e[s];return n})}function cn(i,e){let t=ti(e);return i.map(n=>dr(t,n))}var fr=(i,e)=>i.map((t,n)=>t-e[n]),ds=(i,e,t=1)=>i.map((n,s)=>n.map((r,o)=>r+t*e[s][o])),Jo=(i,e)=>i.map(t=>t.map(n=>e*n)),pr=i=>i.map((e,t)=>e.map((n,s)=>.5*(n+i[s][t]))),dl=(i,e)=>Array.from({length:i},()=>new Array(e).fill(0)),qu=i=>i.map((e,t)=>i.map((n,s)=>t===s?e:0));function mr(i,e){let t=i.length,n=i.map((s,r)=>[...s,...e[r]]);for(let s=0;s<t;s++){n[s]=n[s].map(r=>r/n[s][s]);for(let r=0;r<t;r++){if(r===s)continue;let o=n[r][s];n[r]=n[r].map((a,c)=>a-o*n[s][c])}}return n.map(s=>s.slice(t))}var Ko=i=>Array.from(new Float32Array(Uint8Array.from(atob(i),e=>e.charCodeAt(0)).buffer));var Cx=6.283185307179586;function $u(i,e){let t=e.k_plus+e.k_minus,n=e.k_plus-e.k_minus;return .5*(t*i+n*Math.abs(i))*i}function Zu(i,e,t,n,s){let r=Math.abs(i)-s,o=Math.pow(.5*(r+Math.abs(r)),n),a=i/(Math.abs(i)+1e-30);return .5*(e+t+(e-t)*a)*o}function jo(i){return[i[0]+i[1],i[0]-i[1]]}function Ju(i){return[.5*(i[0]+i[1]),.5*(i[0]-i[1])]}function On(i,e,t){let[,n,s,r,o,a]=i,[c,l]=e,u=t,d=u.b1*Math.cos(s)*Math.sin(o)*c-u.c1*n,h=u.a1*Math.sin(s)+u.a2*Math.cos(s)+u.b2*Math.cos(o)*c-u.c2*r,f=u.a3*Math.cos(s)*Math.sin(o)+u.b3*l-u.c3*a;return[n,d,r,h,a,f]}function Ku(i,e,t,n,s,r){let o=i*n-e*t;return[(n*s-e*r)/o,(i*r-t*s)/o]}function Fs(i,e,t,n){let[,,,s,,r]=On(i,[0,0],n),[,,,o,,a]=On(i,[1,0],n),[,,,c,,l]=On(i,[0,1],n);return Ku(o-s,c-s,a-r,l-r,e-s,t-r)}function ju(i,e,t,n){let[s,r,o,a,,c]=i,l=[s,r,o,a,0*o,c],u=[s,r,o,a,0*o+.5*Math.PI,c],[,d,,h,,]=On(l,[0,0],n),[,f,,p,,]=On(l,[1,0],n),[,v,,g,,]=On(u,[1,0],n);return Ku(v-d,f-d,g-h,p-h,e-d,t-h)}function Jf(i,e,t,n,s){let r=s.e_h-s.d_h*t,o=s.m_c*(s.l_c*i-s.d_c*e)**2+s.m_h*((s.l_h*i-r*e)**2+s.r**2*(1-i**2*n**2)+s.d_h**2*n**2),a=s.m_c*(s.l_c**2+s.d_c**2)+s.m_h*(s.l_h**2+r**2+s.r**2*n**2),c=s.m_h*(s.r**2+s.d_h**2),l=s.m_h*n*(s.r**2*i*t+s.d_h*(s.l_h*e+r*i)),u=s.m_h*((s.r**2+s.d_h**2)*e+s.d_h*t*(s.l_h*i-s.e_h*e)),d=s.m_h*s.d_h*s.l_h*n;return[o,a,c,l,u,d]}function Kf(i,e,t,n,s,r,o,a){let c=a.e_h-a.d_h*t,l=a.l_h*i-c*e,u=a.l_h*e+c*i,d=a.l_c*i-a.d_c*e,h=a.l_c*e+a.d_c*i,f=2*a.m_h*(a.r**2*i*e*n**2-l*u)-2*a.m_c*d*h,p=a.m_h*n*(a.d_h*l-a.r**2*e*t),v=a.m_h*((a.r**2+a.d_h**2)*i-a.d_h*t*(a.l_h*e+a.e_h*i)),g=2*a.m_h*n*(t*(a.d_h**2-a.r**2*i**2)-a.d_h*e*l),m=2*a.m_h*n*(a.d_h*c+a.r**2*t),y=a.m_h*(a.r**2*i*(t**2-n**2)+a.d_h*(t*u+a.d_h*n**2*i)),A=-a.m_h*a.d_h*n*(a.l_h*i-a.e_h*e),b=a.m_h*a.d_h*a.l_h*t;return[s*(f*r+g*o)+p*r**2+(y+v)*r*o+A*o**2,-.5*f*s**2+(y-v)*s*o+m*r*o+b*o**2,-.5*g*s**2+(v-y)*s*r-.5*m*r**2]}function jf(i,e,t,n,s){let r=s.m_h*(s.l_h*i-(s.e_h-s.d_h*t)*e)-s.m_c*(s.l_c*i-s.d_c*e);return[0,s.g*r,s.g*s.m_h*s.d_h*n*i]}function Qf(i,e,t,n,s,r,o){let a=-o.kappa*r;return[-s*n*(o.l_h*i-o.e_h*e)+o.l_p*e*r+a*i*t,o.l_h*t*s+a*n,o.l_p*r]}function ep(i,e){let[t,n,s,r,o,a]=i,[c,l,u]=e,d=n*s-a**2,h=t*s-o**2,f=t*n-r**2,p=o*a-r*s,v=r*a-o*n,g=r*o-t*a,m=t*d+r*p+o*v;return[(d*c+p*l+v*u)/m,(p*c+h*l+g*u)/m,(v*c+g*l+f*u)/m]}function Qu(i,e,t){let[,n,s,r,o,a]=i,[c,l]=e,u=Math.cos(s),d=-Math.sin(s),h=Math.cos(o),f=Math.sin(o),p=Jf(u,d,h,f,t),[v,g,m]=Kf(u,d,h,f,n,-r,a,t),[y,A,b]=jf(u,d,h,f,t),[C,E,x]=Qf(u,d,h,f,c,l,t),[M,U,I]=ep(p,[C-v-y,E-g-A,x-m-b]);return[n,M,r,-U,a,I]}function fl(i,e,t){return e*i+t*i/(i*i+.02*.02)**.5}function eh(i,e,t,n,s){let[r,o,a,c,l,u]=e,[d,h,f,p]=s;return[r,o+d-fl(r,t[0],n[0]),a,c+h+p*Math.cos(i[2])-fl(a,t[1],n[1]),l,u+f-fl(l,t[2],n[2])]}function th(i,e){let[t,n,s,r,o,a]=i;return[t,n,s,r+e*t*t,o,a]}function Yu(i,e,t){let n=.5*(i+Math.abs(i)),s=60*n/(n+.001),r=.5*(900*n+s*e)/Math.abs(t);return .5*(r+Math.abs(r))}function nh(i,e,t,n){let[s,r,o,a,c,l]=e,u=t,[d,h]=n,f=.27*Math.cos(i[4])*c,p=.27*Math.sin(i[4]),v=Yu(i[2]-p-d,o-f,u.b2),g=Yu(i[2]+p-d,o+f,u.b2),m=v+g,y=s/(s*s+.02*.02)**.5;return[s,r-Math.abs(u.b1)*h*m*y,o,a-Math.abs(u.b2)*m,c,l+u.b3*(v-g)]}function ih(i,e){let t=Cx/e;return t*Math.floor(i/t+.5)}function sh(i,e,t){return On(i,Fs(i,e,0,t),t)[1]}function rh(i){let e=1-i;return[[e**3/6,(3*i**3-6*i**2+4)/6,(3*e**3-6*e**2+4)/6,i**3/6],[-.5*e**2,1.5*i**2-2*i,.5+i-1.5*i**2,.5*i**2],[e,3*i-2,1-3*i,i]]}var Px=60;function pl(i,e){if("cubics"in e)return sp(i,e);let{k_plus:t,k_minus:n,exponent:s,dead_zone:r}=e;return s===2&&r===0?$u(i,e):Zu(i,t,n,s,r)}function ml(i,e){if("cubics"in e)return Ix(i,e);let t=i>=0?e.k_plus:e.k_minus,n=t===0?0:i/t,s=e.exponent===2?Math.sqrt(n):n**(1/e.exponent);return Math.sign(i)*(s+(n>0?e.dead_zone:0))}var tp=({cubics:[i,e,t,n]},s,r)=>((i[s]*r+e[s])*r+t[s])*r+n[s];function np(i,e){let t=i.findIndex(n=>n>=e);return Math.min(Math.max((t<0?i.length:t)-1,0),i.length-2)}function ip({voltages:i,thrusts:e}){let t=i.length-1;return[(e[1]-e[0])/(i[1]-i[0]),(e[t]-e[t-1])/(i[t]-i[t-1])]}function sp(i,e){let{voltages:t}=e,n=Math.min(Math.max(i,t[0]),t.at(-1)),s=np(t,n),[r,o]=ip(e);return tp(e,s,n-t[s])+r*Math.min(i-n,0)+o*Math.max(i-n,0)}function Ix(i,e){let{voltages:t,thrusts:n}=e;if(i===sp(0,e))return 0;let s=np(n,i),r=Math.min(Math.max(i,n[0]),n.at(-1)),[o,a]=[0,t[s+1]-t[s]];for(let u=0;u<Px;u++){let d=.5*(o+a);tp(e,s,d)<r?o=d:a=d}let[c,l]=ip(e);return t[s]+a+Math.min(i-n[0],0)/c+Math.max(i-n.at(-1),0)/l}var ui=(i,[e,t])=>Math.min(Math.max(i,e),t),ni=(i,e)=>[pl(i[0],e.front),pl(i[1],e.back)],ii=(i,e)=>jo(ni(i,e));function hi(i,e){let[t,n]=Ju(i);return[ml(t,e.front),ml(n,e.back)]}function Zr([i,e],t){return[Math.max(...ni([i,i],t)),Math.min(...ni([e,e],t))]}function Os(i,e,t){let n=[...i,...e],s=.001,r=n.map((a,c)=>{let l=f=>{let p=n.with(c,n[c]+f);return On(p.slice(0,6),[p[6],p[7]],t)},u=f=>{let[p,v]=[l(f),l(-f)];return p.map((g,m)=>(g-v[m])/(2*f))},[d,h]=[u(s),u(2*s)];return d.map((f,p)=>(4*f-h[p])/3)}),o=i.map((a,c)=>r.map(l=>l[c]));return{A:o.map(a=>a.slice(0,6)),B:o.map(a=>a.slice(6))}}var Di=(i,e)=>Fs([0,0,i,0,0,0],0,0,e);function Si(i,e,[t,n,s],r){let o=(d,h)=>e.map((f,p)=>f+d*h[p]),a=i(e,t),c=i(o(r/2,a),n),l=i(o(r/2,c),n),u=i(o(r,l),s);return e.map((d,h)=>d+r/6*(a[h]+2*(c[h]+l[h])+u[h]))}var rp=[0,2,4],oh=[1,3,5];function op(i,e,t,n,s,{lag:r},o){let a=h=>t.map((f,p)=>r?f+(e[p]-f)*Math.exp(-h/r):f),c=(h,f)=>{let p=On(h,f,o);return oh.forEach((v,g)=>p[v]+=n[g]),p},[l,u,d]=[0,.5,1].map(h=>ii(a(h*s),o));return{x:Si(c,i,[l,u,d],s),rotors:a(s)}}function ah(i,e,t){let n=i.length,s=n+e[0].length,r=Array.from({length:s},(l,u)=>u<n?[...i[u],...e[u]]:new Array(s).fill(0)),o=qu(new Array(s).fill(1)),a=o;for(let l=1;l<=4;l++)o=Jo(cn(r,o),t/l),a=ds(a,o);let c=a.slice(0,n);return{A:c.map(l=>l.slice(0,n)),B:c.map(l=>l.slice(n))}}function ap(i,e,t,n,{noise:s,encoder_noise:r,start_deviations:o}){let a=dl(9,6),c=[s.travel_disturbance,s.elevation_disturbance,s.pitch_disturbance];oh.forEach((p,v)=>{a[p][v]=s.acceleration,a[6+v][3+v]=c[v]});let l=cn(a,ti(a)),[u,d,h]=o.map(p=>p**2),f=qu([u,d,u,d,u,d,h,h,h]);return i.map((p,v)=>{let g=dl(9,9);Os(p,e[v],n).A.forEach((E,x)=>E.forEach((M,U)=>g[x][U]=M)),oh.forEach((E,x)=>g[E][6+x]=1);let{A:m}=ah(g,dl(9,1),t),y=rp.map(E=>f[E]),A=y.map((E,x)=>rp.map((M,U)=>E[M]+(x===U?r**2:0))),b=ti(mr(A,y));f=ds(f,cn(b,y),-1);let C=ds(l,cn(m,cn(l,ti(m))));return f=pr(ds(cn(m,cn(f,ti(m))),C,.5*t)),b})}function lp(i,e,[t,n,s],r,o,a){let[,c,,l,,u]=On(i,e,a),[d,h]=ju(i,c-t,l-n,a),f=i.with(4,ui(Math.atan2(d,Math.max(h,o)),r)),[,p]=Fs(f,l-n,u-s,a);return{x:f,v:[Math.hypot(d,h),p]}}function Lx(i,e,t,n){let{A:s,B:r}=Os(i,e,n);return{A:[...s.map((o,a)=>[...o,...r[a]]),[0,0,0,0,0,0,-1/t,0],[0,0,0,0,0,0,0,-1/t]],B:[...r.map(()=>[0,0]),[1/t,0],[0,1/t]]}}function cp(i,e,t,n,s,r){let[o,a]=[Jo(s.Q,t),Jo(s.R,t)],c=s.M,l=[];for(let u=i.length-1;u>=0;u--){let d=Lx(i[u],e[u],r,n),{A:h,B:f}=ah(d.A,d.B,t),[p,v]=[cn(c,h),cn(c,f)],g=mr(ds(a,cn(ti(f),v)),cn(ti(v),h));c=pr(ds(o,cn(ti(h),ds(p,cn(v,g),-1)))),l.push(g)}return l.reverse()}function ea(i){let e=i.x.length-1,t=i.x.flatMap((n,s)=>s%2===0?[s]:[]);return{x:t.map(n=>i.x[n]),u:t.map(n=>i.u[n]),middle:t.map(n=>i.u[Math.min(n+1,e)])}}function lh(i,e){let{x:t,v:n,gains:s}=i;return{tracking:i,voltages(r,o){let a=Math.min(r,t.length-1);if(s===null)return hi(n[a],e);let[c,l]=dr(s[a],fr(o,t[a]));return hi([n[a][0]-c,n[a][1]-l],e)}}}function Jr({x:i,middle:e},t,n){return{x:i,v:e.map(s=>ii(s,n)),gains:t}}function ch({x:i},e,t){let n=Di(i.at(-1)[2],t);return{x:i,v:i.map(()=>n),gains:i.map(()=>e)}}function uh({x:i,u:e},t,n,s){let r=e.map(o=>ii(o,s));return{regulator:cp(i,r,n,s,t.weights,t.actuator.lag),observer:ap(i,r,n,s,t)}}var Qo=class{constructor(e,t,n){this.task=e;this.gains=t;this.settings=n;let{x:s,u:r,middle:o}=e.reference,{lag:a,delay:c}=n.actuator;[this.x,this.rotors]=[s[0],r[0]],this.pending=Array.from({length:c},()=>r[0]),this.command=o.map((l,u)=>{let d=r[Math.min(u+1,r.length-1)];return l.map((h,f)=>h+a*(d[f]-r[u][f])/e.period)})}task;gains;settings;command;x;pending;disturbance=[0,0,0];rotors;voltages(e,t){let n=this.task.reference.x.length-1,s=Math.min(e,n),{delay:r}=this.settings.actuator,o=fr(t,this.x).filter((f,p)=>p%2===0),a=dr(this.gains.observer[s],o),c=this.x.map((f,p)=>f+a[p]);this.disturbance=this.disturbance.map((f,p)=>f+a[6+p]);let l={x:c,rotors:this.rotors};for(let f of this.pending)l=this.predicted(l,f);let u=this.regulated(Math.min(s+r,n),l),[d,...h]=[...this.pending,this.limited(u)];return{x:this.x,rotors:this.rotors}=this.predicted({x:c,rotors:this.rotors},d),this.pending=h,u}limited(e){return e.map(t=>ui(t,this.task.amplifier))}predicted({x:e,rotors:t},n){let{period:s,parameters:r}=this.task;return op(e,t,n,this.disturbance,s,this.settings.actuator,r)}regulated(e,{x:t,rotors:n}){let{reference:s,pitchLimits:r,parameters:o}=this.task,{least_lift:a}=this.settings,[c,l,u]=[n,s.u[e],this.command[e]].map(f=>ii(f,o)),d=lp(s.x[e],l,this.disturbance,r,a,o),h=dr(this.gains.regulator[e],[...fr(t,d.x),...fr(c,d.v)]);return hi(u.map((f,p)=>f+(d.v[p]-l[p])-h[p]),o)}};function dh({kalman:i,learned:e}){if(e===null)return{kalman:i,learned:e};let{arrays:t,...n}=e,s=(l,u)=>{let d=Ko(l),h=d.length/u;return Array.from({length:u},(f,p)=>d.slice(p*h,(p+1)*h))},[r,o,a]=[t.bias_input,t.bias_hidden,t.bias].map(Ko),c={weight_input:s(t.weight_input,r.length),weight_hidden:s(t.weight_hidden,o.length),weight:s(t.weight,a.length),bias_input:r,bias_hidden:o,bias:a};return{kalman:i,learned:{...n,arrays:c}}}var hh=(i,e,t)=>dr(i,t).map((n,s)=>n+e[s]);function up({arrays:i},e,t){let n=t.length,s=hh(i.weight_input,i.bias_input,e),r=hh(i.weight_hidden,i.bias_hidden,t),o=c=>.5+.5*Math.tanh(.5*(s[c]+r[c])),a=t.map((c,l)=>{let u=Math.tanh(s[2*n+l]+o(l)*r[2*n+l]);return u+o(n+l)*(c-u)});return{action:hh(i.weight,i.bias,a).map(Math.tanh),hidden:a}}var ta=class{constructor(e,t,n,s){this.base=e;this.task=t;this.network=n;this.settings=s;this.hidden=n.arrays.weight_hidden[0].map(()=>0)}base;task;network;settings;hidden;last=[0,0];voltages(e,t){let{reference:n,amplifier:s}=this.task,r=this.base.voltages(e,t),o=this.features(Math.min(e,n.x.length-1),t,r),{action:a,hidden:c}=up(this.network,o,this.hidden);return[this.hidden,this.last]=[c,a],r.map((l,u)=>ui(l,s)+this.network.scale*a[u])}features(e,t,n){let{reference:s,amplifier:r,period:o}=this.task,{tolerance:a,state_scale:c,largest:l}=this.settings,[u,d]=[.5*(r[0]+r[1]),.5*(r[1]-r[0])],h=p=>p.map(v=>(v-u)/d),f=s.x.length-1;return[...fr(t,s.x[e]).map((p,v)=>p/a[v]),...h(n),...h(s.middle[e]),...this.last,...this.network.ahead.flatMap(p=>s.x[Math.min(e+Math.round(p/o),f)].map((g,m)=>g/c[m]).slice(1))].map(p=>ui(p,[-l,l]))}};var Dx=40,hp=.05;function fh({Q:i,R:e},t,n){let s=[0,0,t,0,0,0],{A:r,B:o}=Os(s,Di(t,n),n),a={A:r,gain:mr(e,ti(o))},c=i.flat();for(let l=0;l<Dx;l+=hp)c=Si((u,d)=>dp(u,d,i,e),c,[a,a,a],hp);return{Q:i,R:e,M:pr(ph(c))}}var ph=i=>Array.from({length:6},(e,t)=>i.slice(6*t,6*t+6));function dp(i,{A:e,gain:t},n,s){let r=ph(i),o=cn(r,e),a=cn(t,r),c=cn(ti(a),cn(s,a));return r.flatMap((l,u)=>l.map((d,h)=>o[u][h]+o[h][u]-c[u][h]+n[u][h]))}function na(i,{Q:e,R:t,M:n},s){let r=i.x.map((l,u)=>{let{A:d,B:h}=Os(l,ii(i.u[u],s),s);return{A:d,gain:mr(t,ti(h))}}),o=i.x.length-1,a=n,c=[cn(r[o].gain,a)];for(let l=o;l>0;l-=2){let u=Si((d,h)=>dp(d,h,e,t),a.flat(),[r[l],r[l-1],r[l-2]],2*i.step);a=pr(ph(u)),c.unshift(cn(r[l-2].gain,a))}return c}function mh(i,e,t){let{parameters:n,amplifier:s,control_period:r}=t,o=ea(i),a={reference:o,pitchLimits:e,amplifier:s,period:r,parameters:n},c=fp(()=>na(i,t.yours??t.weights,n)),l=fp(()=>na(i,t.weights,n)),u=new Map,d=v=>(u.has(v)||u.set(v,uh(o,v,r,n)),u.get(v)),h=v=>lh(v,n),f=new Map,p=v=>(f.has(v)||f.set(v,na(i,v,n)),h(Jr(o,f.get(v),n)));return{"feedforward+tvlqr":()=>h(Jr(o,l(),n)),yours:()=>h(Jr(o,c(),n)),"open-loop":()=>h(Jr(o,null,n)),"hover-lqr":()=>h(ch(o,t.hover_gain,n)),"kalman-lqr":({kalman:v})=>new Qo(a,d(v),v),residual:({learned:v})=>v&&new ta(p(v.weights),a,v,t.features)}}function fp(i){let e;return()=>e??=i()}var Nx=1e3,pp=1e-4;function Kr(i,e){if(i===null||typeof i!="object")return i;if(Array.isArray(i))return i.map(t=>Kr(t,e));if("options"in i&&Array.isArray(i.options))return Kr(i.options[Math.floor(e()*i.options.length)],e);if("low"in i&&"high"in i){let{low:t,high:n}=i;return t+(n-t)*e()}return Object.fromEntries(Object.entries(i).map(([t,n])=>[t,Kr(n,e)]))}function mp({parameters:i,thrust_map:e}){let t={k_plus:i.k_plus,k_minus:i.k_minus,exponent:2,dead_zone:0},n=e??t;return{...i,..."front"in n?n:{front:n,back:n}}}function ia(i,e,t){let{rotors:n,friction:s,parameters:r,sensors:o}=i,a=mp(i),c=1-n.thrust_loss;if(i.hover_voltage){let[p,v]=ni([i.hover_voltage,i.hover_voltage],a);c*=-r.a2/(r.b2*(p+v))}let l=Math.floor(n.delay/e+pp),u=Math.max(n.delay-e*l,0),d=u>pp*e?u:0,h=i.rig===null&&n.thrust_loss===0&&n.delay===0&&n.gains.every(p=>p===1)&&[...s.viscous,...s.coulomb].every(p=>p===0)&&i.thrust_map===null&&!i.table&&i.travel_lift===0&&i.disturbances.length===0&&!o?.zeros.some(p=>p!==0),f=[c*n.gains[0],c*n.gains[1]];return{plant:i,model:a,shares:f,periods:l,rest:d,steps:p=>h&&!p?1:Math.ceil(e/t-1e-9)}}function sa({plant:i,periods:e},t,n){return{x:[...t],motors:n,rotors:n,arrived:n,pending:Array.from({length:e},()=>n),angles:gp(i,t),rates:[t[1],t[3],t[5]]}}function gh(i){return i.angles.flatMap((e,t)=>[e,i.rates[t]])}function ra({plant:i,model:e,shares:t,rest:n,steps:s},r,o,a,c,l,u=l.length>0){let{rotors:d,friction:h,rig:f,table:p}=i,v=s(u),g=p?[p.elevation,p.friction]:[Nx,0],[m,...y]=[...r.pending,o],{x:A,motors:b,rotors:C}=r;function E(x,M,U){let I=d.slew===null?1/0:d.slew*U;b=x.map((P,V)=>Math.min(Math.max(P,b[V]-I),b[V]+I));let D=U/v,G=d.lag?Math.exp(-.5*D/d.lag):0,H=P=>[b[0]+G*(P[0]-b[0]),b[1]+G*(P[1]-b[1])];d.lag||(C=b);for(let P=0;P<v;P++){let[V,z]=[H(C),H(H(C))],N=M+P*D,re=[...Ux(l,N,D),0],q=i.disturbances.reduce((ue,{loss:de,time:K,duration:xe})=>ue*(1-de*Math.min(Math.max((N-K+.5*D)/xe,0),1)),1),$=ue=>{let[de,K]=ni(ue,e);return jo([t[0]*q*de,t[1]*q*K])};A=Si((ue,de)=>{let K=f===null?On(ue,de,i.parameters):Qu(ue,de,f),xe=eh(ue,K,h.viscous,h.coulomb,re);return!p&&i.travel_lift===0?xe:th(nh(ue,xe,i.parameters,g),i.travel_lift)},A,[$(C),$(V),$(z)],D),C=z}}return n>0&&E(r.arrived,a,n),E(m,a+n,c-n),Fx(i,{...r,x:A,motors:b,rotors:C,arrived:m,pending:y},c)}function Ux(i,e,t){let n=[0,0,0];for(let s of i){let r=a=>Math.min(Math.max(a,0),s.duration),o=r(e+t-s.time)-r(e-s.time);n[s.axis]+=s.acceleration*o/t}return n}function gp({sensors:i},e){return[e[0],e[2],e[4]].map((t,n)=>i===null?t:ih(t-i.zeros[n],i.counts[n]))}function Fx(i,e,t){let{x:n}=e,s=gp(i,n);if(i.sensors===null)return{...e,angles:s,rates:[n[1],n[3],n[5]]};let r=Math.exp(-t/i.sensors.rate_filter),o=s.map((a,c)=>r*e.rates[c]+(1-r)*(a-e.angles[c])/t);return{...e,angles:s,rates:o}}var oa=class{constructor(e,t,n,s,r){this.controller=e;this.plant=t;this.rules=n;this.ready=ia(t,n.controlPeriod,n.substep),this.state=sa(this.ready,s,r),this.x=[this.state.x]}controller;plant;rules;x;u=[];crashed=!1;state;ready;get rotors(){return this.state.rotors}step(e){if(this.crashed)return;let{controlPeriod:t,amplifier:n,pitchStop:s}=this.rules,r=this.x.length-1,a=this.controller.voltages(r,gh(this.state)).map(d=>ui(d,n)),[c,l]=[r*t,(r+1)*t],u=e.filter(({time:d,duration:h})=>d<l&&d+h>c);this.state=ra(this.ready,this.state,a,c,t,u,e.length>0),this.u.push(a),this.x.push(this.state.x),this.crashed=Math.abs(this.state.x[4])>s}};var xp=4;function xh(i,[e,t],n,s,r){let{duration:o,goal:a,limits:c}=i,l=s,[u,d]=c.pitch.map(x=>x*(1-n)),[h,f]=c.u.map(x=>ni([x,x],l)[0]),p=(x,M)=>x.reduce((U,I,D)=>U+I*(M**(D+2)-M),0);function v(x,[M,,U,I]){let D=4/(d-u),G=.5*(1+Math.tanh(.5*D*U)),H=u+(d-u)*G,P=4*G*(1-G),V=D*P*(1-2*G)*I**2,z=l.a1*Math.sin(M)+l.a2*Math.cos(M),N=l.a3*Math.cos(M)*Math.sin(H),re=ui(p(t,x/o),[(N+l.b3*(h-f)-V)/P,(N+l.b3*(f-h)-V)/P]),q=(V+P*re-N)/l.b3,$=l.b2*Math.cos(H),te=ui(p(e,x/o),[z+$*(2*f-Math.abs(q)),z+$*(2*h+Math.abs(q))]);return{y2:H,dy2:P*I,dxi2:re,ddy1:te,v:[(te-z)/$,q]}}function g(x,M){let{y2:U,dxi2:I,ddy1:D,v:G}=v(M,x);return[x[1],D,x[3],I,x[5],l.b1*Math.cos(x[0])*Math.sin(U)*G[0]]}let m=Math.round(o/r),A=[0,0,(d-u)/4*Math.log(-u/d),0,0,0],b=[],C=[],E=r/xp;for(let x=0;x<=m;x++){let[M,U,,,I,D]=A,{y2:G,dy2:H,v:P}=v(x*r,A);b.push([I,D,M,U,G,H]),C.push(hi(P,l));for(let V=0;V<xp;V++){let z=x*r+V*E;A=Si(g,A,[z,z+E/2,z+E],E)}}return b[m]=[a[0],0,a[1],0,0,0],C[m]=hi(Di(a[1],l),l),{step:r,x:b,u:C}}var _p=2;function _h({duration:i,c:e},t,n,s){let r=Ko(e),o=r.length/2-3,a=o/i;function c(m){let y=o*Math.min(Math.max(m/i,0),1),A=Math.min(Math.floor(y),o-1);return rh(y-A).map((b,C)=>{let E=x=>a**C*b.reduce((M,U,I)=>M+U*r[2*(A+I)+x],0);return[E(0),E(1)]})}let l=([m,y],[A,b])=>[m,y,A[0],b[0],A[1],b[1]],u=(m,y)=>{let A=c(y);return[m[1],sh(l(m,A),A[2][0],n)]},d=2*Math.ceil(i/(2*s)-1e-9),h=s/_p,f=hi(Di(t[1],n),n),p=[0,0],v=[],g=[];for(let m=0;m<=d;m++){if(m*s>=i-1e-9){v.push([t[0],0,t[1],0,0,0]),g.push(f);continue}let y=c(m*s);v.push(l(p,y)),g.push(hi(Fs(v[m],y[2][0],y[2][1],n),n));for(let A=0;A<_p;A++){let b=m*s+A*h;p=Si(u,p,[b,b+h/2,b+h],h)}}return{step:s,x:v,u:g}}var gr={lag:{name:"rotor lag",unit:"s",digits:2,max:.3,step:.01},friction:{name:"friction",unit:"1/s",digits:2,max:.6,step:.02},loss:{name:"thrust loss",unit:"%",digits:0,max:30,step:1},delay:{name:"delay",unit:"s",digits:2,max:.2,step:.01},zero:{name:"pitch zero",unit:"\xB0",digits:0,min:-8,max:8,step:1}},Bs=Object.keys(gr),ks=["travel","elevation","pitch","effort"],Ox=4,Bx=40,vn=(i,e)=>i.rigs.find(t=>t.name===e)??i.rigs[0];function xr(i,e){let{spline:t,paper:n}=e.grids,s=n?{method:"paper",duration:i.paper.duration,pitchLimit:i.paper.pitch_limit_deg,window:i.paper.window}:{method:"spline",duration:t.durations[3],pitchLimit:50,window:t.windows[Math.min(1,t.windows.length-1)]},r={travel:0,elevation:0,pitch:0,effort:0};return zs({rig:e.name,...s,startOff:3,plant:Object.keys(e.plants)[0],draw:1,effects:{},weights:r},i)}var vh=(i,e)=>i.reduce((t,n,s)=>e(n)<e(i[t])?s:t,0);function gl(i,e){let t=(n,s)=>n===null||s===null?n===s?0:1e3:Math.abs(n-s);return{duration:vh(e.durations,n=>t(n,i.duration)),pitch:vh(e.pitch_limits_deg,n=>Math.abs(n-i.pitchLimit)),window:vh(e.windows,([n,s])=>Math.abs(n-i.window[0])+Math.abs(s-i.window[1]))}}var _r=(i,e)=>e==="paper"&&i.grids.paper||i.grids.spline;function zs(i,e){let t=vn(e,i.rig),n=i.method==="paper"&&t.grids.paper?"paper":"spline",s=_r(t,n),r=gl(i,s);return{...i,rig:t.name,method:n,duration:s.durations[r.duration],pitchLimit:s.pitch_limits_deg[r.pitch],window:s.windows[r.window],plant:i.plant in t.plants?i.plant:Object.keys(t.plants)[0],startOff:Math.min(Math.max(Math.round(i.startOff),0),10)}}var xl=(i,e)=>{let t=_r(vn(e,i.rig),i.method),n=gl(i,t);return t.plans[n.pitch][n.window][n.duration]};function Gs(i,e){let t=xl(i,e);return t===null?null:Array.isArray(t)?i.duration:t.duration}function _l(i,e){let t=vn(e,i.rig),n=t.plants[i.plant],s=Kr(n,Gx(i.draw)),r=JSON.stringify(s)!==JSON.stringify(n),{lag:o,friction:a,loss:c,delay:l,zero:u}=i.effects,d={...s,rotors:{...s.rotors,...o!==void 0&&{lag:o},...c!==void 0&&{thrust_loss:c/100},...l!==void 0&&{delay:l}},friction:a===void 0?s.friction:{...s.friction,viscous:[a,a,a]}};if(u!==void 0){let h=s.sensors??{counts:t.encoder_counts,rate_filter:.03,zeros:[0,0,0]};d.sensors={...h,zeros:h.zeros.with(2,hr(u))}}return{plant:d,isRandom:r}}function la({rotors:i,friction:e,sensors:t}){return{lag:i.lag,friction:e.viscous.reduce((n,s)=>n+s/3,0),loss:100*i.thrust_loss,delay:i.delay,zero:Vt(t?.zeros[2]??0)}}var aa=new Map;function kx({weights:i},e,t){let n=[i.travel,i.travel,i.elevation,i.elevation,i.pitch,i.pitch].map(o=>10**o),s=e.weights.Q.map((o,a)=>o.map(c=>n[a]*c)),r=e.weights.R.map(o=>o.map(a=>10**i.effort*a));return fh({Q:s,R:r},t[1],e.parameters)}function zx(i,e,t,n){let s=n?null:xl(i,e);if(!n&&s===null)return null;let r=JSON.stringify([t.name,i.method,i.duration,i.pitchLimit,i.window,i.weights,n?.name,n?.x.length]),o=aa.get(r);if(o)return o;let a=ca(i),c=e.control_period/2,l=n?{step:n.step,x:n.x,u:n.u}:Array.isArray(s)?xh({duration:i.duration,goal:e.goal,limits:a},[s.slice(0,e.kappa[0]),s.slice(e.kappa[0])],e.pitch_reserve,t.parameters,c):_h(s,e.goal,t.parameters,c),u,d={...t,control_period:e.control_period,features:e.features,get yours(){return u??=kx(i,t,e.goal)}},h=Object.fromEntries(Object.entries(t.networks).map(([p,v])=>[p,dh(v)])),f={plan:l,controllers:mh(l,a.pitch,d),networks:h};return aa.set(r,f),aa.size>Bx&&aa.delete(aa.keys().next().value),f}function ca({pitchLimit:i,window:e}){return{u:e,pitch:[-hr(i),hr(i)]}}var jr=class i{constructor(e,t,n,s){this.setup=e;this.log=n;this.ready=s;this.rig=vn(t,e.rig),{plant:this.plant,isRandom:this.isRandom}=_l(e,t);let r=t.control_period,o=ea(s.plan),a=o.x.length-1;this.duration=r*a;let c=Array.from({length:a+1+(n?0:Math.round(Ox/r))},(u,d)=>Math.min(d,a));this.reference={x:c.map(u=>o.x[u]),u:c.map(u=>o.u[u]),middle:c.map(u=>o.middle[u])},this.rules={controlPeriod:r,amplifier:this.rig.amplifier,pitchStop:this.rig.pitch_stop,substep:t.substep};let l=n?0:hr(e.startOff);this.start=this.reference.x[0].map((u,d)=>u+(d===0?-l:d===2?l:0)),this.rest=n?n.u[0]:hi(Di(0,this.rig.parameters),this.rig.parameters)}setup;log;ready;rig;plant;isRandom;reference;duration;rules;start;rest;static make(e,t,n=null){let s=zx(e,t,vn(t,e.rig),n);return s&&new i(e,t,n,s)}get steps(){return this.reference.x.length-1}get network(){return this.ready.networks[this.rig.network_for[this.setup.plant]]}offers(e){return e!=="residual"||this.network.learned!==null}begin(e){let t=this.ready.controllers[e](this.network);return t&&new oa(t,this.plant,this.rules,this.start,this.rest)}fly(e,t=[]){let n=this.begin(e);for(;n&&!n.crashed&&n.x.length<=this.steps;)n.step(t);return n}gains(e){let{controller:t}=this.begin(e)??{};return t&&"tracking"in t&&t.tracking.gains||null}endError(e){if(e.crashed)return 1/0;let[t,n]=[e.x.at(-1),this.reference.x.at(-1)];return Vt(Math.hypot(t[0]-n[0],t[2]-n[2]))}rmsError(e){if(e.crashed)return 1/0;let t=e.x.map((n,s)=>(n[0]-this.reference.x[s][0])**2+(n[2]-this.reference.x[s][2])**2);return Vt(Math.sqrt(t.reduce((n,s)=>n+s,0)/t.length))}saturation(e){let[t,n]=this.rig.amplifier;return e.u.filter(r=>r.some(o=>o<=t+1e-9||o>=n-1e-9)).length/Math.max(e.u.length,1)}};function Gx(i){let e=i>>>0;return()=>{e=e+1831565813>>>0;let t=Math.imul(e^e>>>15,1|e);return t=t+Math.imul(t^t>>>7,61|t)^t,((t^t>>>14)>>>0)/4294967296}}function yh(i,e){let t=URL.createObjectURL(e);J("a",{href:t,download:i}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e3)}function yp(i,e,t){let n=["travel","elevation","pitch"],r=["t",...[...i.map(([a])=>a),"plan"].flatMap(a=>[...n.map(c=>`${a} ${c}_deg`),`${a} u_front`,`${a} u_back`])],o=e.x.map((a,c)=>{let u=[...i.map(([,{x:d,u:h}])=>[d[c],h[Math.min(c,h.length-1)]]),[a,e.u[c]]].flatMap(([d,h])=>d&&h?[...[d[0],d[2],d[4]].map(Vt),...h].map(f=>f.toFixed(6)):["","","","",""]);return[(c*t).toFixed(4),...u].join(",")});return[r.map(a=>/[",]/.test(a)?`"${a.replaceAll('"','""')}"`:a).join(","),...o,""].join(`
`)}function bp(i,e,t,n){let[r,o,a]=[1200,16,170],c=3,l=Math.round(r*i.clientHeight/Math.max(i.clientWidth,1)),u=Math.ceil(t.length/c),d=J("canvas",{width:2*r,height:2*(40+l+u*(a+26)+o)}),h=d.getContext("2d");h.scale(2,2);let f=(v,g,m,y=400)=>{h.font=`${y} 13px system-ui, sans-serif`,h.fillText(v,g,m)};h.fillStyle=ci("paper"),h.fillRect(0,0,r,d.height),h.drawImage(i,0,40,r,l),h.fillStyle=ci("ink"),f(n,o,26,600);let p=i.getBoundingClientRect();for(let v of e){let g=v.getBoundingClientRect(),m=r/p.width,[y,A]=[(g.left-p.left)*m+o,40+(g.top-p.top)*m];f(v.querySelector(".name").textContent,y,A+22,600),f([...v.querySelectorAll(".numbers span")].map(b=>b.textContent).join("   "),y,A+g.height*m-10)}return t.forEach((v,g)=>{let m=o+g%c*((r-o)/c),y=40+l+Math.floor(g/c)*(a+26);f(`${v.options.title} (${v.options.unit})`,m,y+20,600),h.drawImage(v.canvas,m,y+26,(r-o)/c-o,a)}),d}var Vx=/^(t|time|zeit)\b/i,Hx=[/travel/i,/elev/i,/pitch/i,/(u|v|volt\w*)[ _-]*f|front/i,/(u|v|volt\w*)[ _-]*b|back|rear/i],Wx=["travel","elevation","pitch","front voltage","back voltage"],Xx=/ref|plan|rate|des|target|set/i,vp=4;function Mp(i,e,t){let n=i.split(/\r?\n/).filter(M=>M.trim()&&!M.startsWith("#"));if(n.length<3)throw new Error(`${e}: must have a line of names and at least two of numbers`);let s=[",",";","	"].find(M=>n[0].includes(M))??",",r=n[0].split(s).map(M=>M.trim().replaceAll('"',"")),o=(M,U)=>{let I=r.findIndex(D=>M.test(D)&&!Xx.test(D));if(I<0)throw new Error(`${e}: must have a column for ${U}; it has ${r.join(", ")}`);return I},[a,...c]=[o(Vx,"the time"),...Hx.map((M,U)=>o(M,Wx[U]))],l=n.slice(1).map(M=>M.split(s).map(Number)),u=[a,...c],d=l.filter(M=>u.every(U=>Number.isFinite(M[U]))),h=d.map(M=>M[a]-d[0][a]);if(d.length<2||!h.every((M,U)=>U===0||M>h[U-1]))throw new Error(`${e}: must have numbers, and times that rise from line to line`);let f=c.map(M=>/deg|°/i.test(r[M])?hr(1):1),p=c.map((M,U)=>d.map(I=>I[M]*f[U])),v=(M,U)=>{let I=Math.min(Math.floor(U/h.at(-1)*(h.length-1)),h.length-2);for(;I>0&&h[I]>U;)I--;for(;I<h.length-2&&h[I+1]<=U;)I++;let D=Math.min(Math.max((U-h[I])/(h[I+1]-h[I]),0),1);return M[I]+D*(M[I+1]-M[I])},g=2*Math.floor(h.at(-1)/(2*t)),m=Array.from({length:g+1},(M,U)=>U*t),[y,A,b,C,E]=p.map(M=>m.map(U=>v(M,U))),x=[y,A,b].map(M=>qx(M,t));return{name:e,step:t,x:m.map((M,U)=>[y[U],x[0][U],A[U],x[1][U],b[U],x[2][U]]),u:m.map((M,U)=>[C[U],E[U]])}}function qx(i,e){return i.map((t,n)=>{let[s,r]=[Math.max(n-vp,0),Math.min(n+vp,i.length-1)],o=.5*(s+r),[a,c]=[0,0];for(let l=s;l<=r;l++)a+=(l-o)*i[l],c+=(l-o)**2;return a/c/e})}function Sp(i,e,t){let n=ia({...e,disturbances:[]},t.controlPeriod,t.substep),s=Math.round(t.controlPeriod/i.step),r=Math.round(1/t.controlPeriod),o=[0,0,0],a=0;for(let c=0;c+r*s<i.x.length;c+=r*s/2){let l=sa(n,i.x[c],i.u[c]);for(let u=0;u<r;u++)l=ra(n,l,i.u[c+u*s],0,t.controlPeriod,[],!1);[0,2,4].forEach((u,d)=>o[d]+=(l.x[u]-i.x[c+r*s][u])**2),a+=1}return o.map(c=>Vt(Math.sqrt(c/Math.max(a,1))))}function wp(i,e,t){let n=xr(t,vn(t,i.rig)),s=new URLSearchParams,r=(a,c,l)=>{`${c}`!=`${l}`&&s.set(a,`${c}`)};r("rig",i.rig,t.rigs[0].name),r("plan",i.method,n.method),r("T",i.duration??"fastest",n.duration),r("pitch",i.pitchLimit,n.pitchLimit),r("window",i.window.join("~"),n.window.join("~")),r("off",i.startOff,n.startOff),r("plant",i.plant,n.plant),r("draw",i.draw,n.draw);for(let a of Bs)i.effects[a]!==void 0&&s.set(a,`${i.effects[a]}`);r("weights",ks.map(a=>i.weights[a]).join("~"),ks.map(()=>0).join("~")),r("show",e.join("~"),Tp(t).join("~"));let o=s.toString();return o?`#${o}`:""}var Tp=i=>i.policies.filter(({shown:e})=>e).map(({name:e})=>e);function bh(i,e){let t=new URLSearchParams(i.replace(/^#/,"")),n=xr(e,vn(e,t.get("rig")??"")),s=(u,d)=>{let h=Number(t.get(u)??Number.NaN);return Number.isFinite(h)?h:d},r=(u,d)=>{let h=(t.get(u)??"").split("~").map(Number);return h.length===d&&h.every(Number.isFinite)?h:null},o=r("weights",ks.length)??ks.map(()=>0),a={...n,method:t.get("plan")==="spline"?"spline":t.get("plan")==="paper"?"paper":n.method,duration:t.get("T")==="fastest"?null:s("T",n.duration??Number.NaN)||n.duration,pitchLimit:s("pitch",n.pitchLimit),window:r("window",2)??n.window,startOff:s("off",n.startOff),plant:t.get("plant")??n.plant,draw:Math.max(1,Math.round(s("draw",n.draw))),effects:Object.fromEntries(Bs.flatMap(u=>t.has(u)?[[u,s(u,0)]]:[])),weights:Object.fromEntries(ks.map((u,d)=>[u,Math.min(Math.max(o[d],-2),2)]))},c=e.policies.map(({name:u})=>u),l=t.has("show")?t.get("show").split("~").filter(u=>c.includes(u)):Tp(e);return{setup:zs(a,e),shown:l}}var Yx="http://www.w3.org/1998/Math/MathML";function vr(i,...e){let t=document.createElementNS(Yx,i);return t.append(...e),t}function Vs(i){return/^[\d.]+$/.test(i)?vr("mn",i):vr(/^[\p{L}\p{M}]+$/u.test(i)?"mi":"mo",i)}function Ep(i){let e=i.split(" ").map(n=>{let[,s,r,o]=/^([^_^]+)(?:_([^^]+))?(?:\^(.+))?$/.exec(n);return r&&o?vr("msubsup",Vs(s),Vs(r),Vs(o)):r?vr("msub",Vs(s),Vs(r)):o?vr("msup",Vs(s),Vs(o)):Vs(s)}),t=vr("math",vr("mrow",...e));return t.setAttribute("display","block"),J("div",{class:"equation"},t)}var $x="uplot",Zx="u-hz",Jx="u-vt",Kx="u-title",jx="u-wrap",Qx="u-under",e_="u-over",t_="u-axis",Mr="u-off",n_="u-select",i_="u-cursor-x",s_="u-cursor-y",r_="u-cursor-pt",o_="u-legend",a_="u-live",l_="u-inline",c_="u-series",u_="u-marker",Ap="u-label",h_="u-value",ha="width",da="height";var Rp="bottom",Qr="left",Mh="right",kh="#000",Cp=kh+"0",Sh="mousemove",Pp="mousedown",wh="mouseup",Ip="mouseenter",Lp="mouseleave",Dp="dblclick",d_="resize",f_="scroll",Np="change",Sl="dppxchange",zh="--",oo=typeof window<"u",Ch=oo?document:null,to=oo?window:null,p_=oo?navigator:null,Dt,vl;function Ph(){let i=devicePixelRatio;Dt!=i&&(Dt=i,vl&&Lh(Np,vl,Ph),vl=matchMedia(`(min-resolution: ${Dt-.001}dppx) and (max-resolution: ${Dt+.001}dppx)`),Sr(Np,vl,Ph),to.dispatchEvent(new CustomEvent(Sl)))}function di(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Ih(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function $t(i,e,t){i.style[e]=t+"px"}function Ni(i,e,t,n){let s=Ch.createElement(i);return e!=null&&di(s,e),t?.insertBefore(s,n),s}function wi(i,e){return Ni("div",i,e)}var Up=new WeakMap;function Qi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Up.get(i);r!=o&&(i.style.transform=r,Up.set(i,r),e<0||t<0||e>n||t>s?di(i,Mr):Ih(i,Mr))}var Fp=new WeakMap;function Op(i,e,t){let n=e+t,s=Fp.get(i);n!=s&&(Fp.set(i,n),i.style.background=e,i.style.borderColor=t)}var Bp=new WeakMap;function kp(i,e,t,n){let s=e+""+t,r=Bp.get(i);s!=r&&(Bp.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Gh={passive:!0},m_={...Gh,capture:!0};function Sr(i,e,t,n){e.addEventListener(i,t,n?m_:Gh)}function Lh(i,e,t,n){e.removeEventListener(i,t,Gh)}oo&&Ph();function Ui(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:fi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function fm(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var pm=i=>i!=null,mm=i=>i!=null&&i>0,El=fm(pm),g_=fm(mm);function x_(i,e,t,n=0,s=!1){let r=s?g_:El,o=s?mm:pm;[e,t]=r(i,e,t);let a=i[e],c=i[e];if(e>-1)if(n==1)a=i[e],c=i[t];else if(n==-1)a=i[t],c=i[e];else for(let l=e;l<=t;l++){let u=i[l];o(u)&&(u<a?a=u:u>c&&(c=u))}return[a??Ht,c??-Ht]}function Al(i,e,t,n){let s=Vp(i),r=Vp(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?fs:gm,a=s==1?fi:Ti,c=r==1?Ti:fi,l=a(o(bn(i))),u=c(o(bn(e))),d=no(t,l),h=no(t,u);return t==10&&(l<0&&(d=Wt(d,-l)),u<0&&(h=Wt(h,-u))),n||t==2?(i=d*s,e=h*r):(i=ym(i,d),e=Rl(e,h)),[i,e]}function Vh(i,e,t,n){let s=Al(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Hh=.1,zp={mode:3,pad:Hh},pa={pad:0,soft:null,mode:0},__={min:pa,max:pa};function wl(i,e,t,n){return Cl(t)?Gp(i,e,t):(pa.pad=t,pa.soft=n?0:null,pa.mode=n?3:0,Gp(i,e,__))}function Ct(i,e){return i??e}function v_(i,e,t){for(e=Ct(e,0),t=Ct(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Gp(i,e,t){let n=t.min,s=t.max,r=Ct(n.pad,0),o=Ct(s.pad,0),a=Ct(n.hard,-Ht),c=Ct(s.hard,Ht),l=Ct(n.soft,Ht),u=Ct(s.soft,-Ht),d=Ct(n.mode,0),h=Ct(s.mode,0),f=e-i,p=fs(f),v=$n(bn(i),bn(e)),g=fs(v),m=bn(g-p);(f<1e-24||m>10)&&(f=0,(i==0||e==0)&&(f=1e-24,d==2&&l!=Ht&&(r=0),h==2&&u!=-Ht&&(o=0)));let y=f||v||1e3,A=fs(y),b=no(10,fi(A)),C=y*(f==0?i==0?.1:1:r),E=Wt(ym(i-C,b/10),24),x=i>=l&&(d==1||d==3&&E<=l||d==2&&E>=l)?l:Ht,M=$n(a,E<x&&i>=x?x:Fi(x,E)),U=y*(f==0?e==0?.1:1:o),I=Wt(Rl(e+U,b/10),24),D=e<=u&&(h==1||h==3&&I>=u||h==2&&I<=u)?u:-Ht,G=Fi(c,I>D&&e<=D?D:$n(D,I));return M==G&&M==0&&(G=100),[M,G]}var y_=new Intl.NumberFormat(oo?p_.language:"en-US"),Wh=i=>y_.format(i),pi=Math,Ml=pi.PI,bn=pi.abs,fi=pi.floor,yn=pi.round,Ti=pi.ceil,Fi=pi.min,$n=pi.max,no=pi.pow,Vp=pi.sign,fs=pi.log10,gm=pi.log2,b_=(i,e=1)=>pi.sinh(i)*e,Th=(i,e=1)=>pi.asinh(i/e),Ht=1/0;function Hp(i){return(fs((i^i>>31)-(i>>31))|0)+1}function Dh(i,e,t){return Fi($n(i,e),t)}function xm(i){return typeof i=="function"}function Tt(i){return xm(i)?i:()=>i}var M_=()=>{},_m=i=>i,vm=(i,e)=>e,S_=i=>null,Wp=i=>!0,Xp=(i,e)=>i==e,w_=/\.\d*?(?=9{6,}|0{6,})/gm,wr=i=>{if(Mm(i)||Ws.has(i))return i;let e=`${i}`,t=e.match(w_);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${wr(s)}e${r}`}return Wt(i,n)};function yr(i,e){return wr(Wt(wr(i/e))*e)}function Rl(i,e){return wr(Ti(wr(i/e))*e)}function ym(i,e){return wr(fi(wr(i/e))*e)}function Wt(i,e=0){if(Mm(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return yn(n)/t}var Ws=new Map;function bm(i){return((""+i).split(".")[1]||"").length}function ga(i,e,t,n){let s=[],r=n.map(bm);for(let o=e;o<t;o++){let a=bn(o),c=Wt(no(i,o),a);for(let l=0;l<n.length;l++){let u=i==10?+`${n[l]}e${o}`:n[l]*c,d=(o>=0?0:a)+(o>=r[l]?0:r[l]),h=i==10?u:Wt(u,d);s.push(h),Ws.set(h,d)}}return s}var ma={},Xh=[],io=[null,null],Hs=Array.isArray,Mm=Number.isInteger,T_=i=>i===void 0;function qp(i){return typeof i=="string"}function Cl(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function E_(i){return i!=null&&typeof i=="object"}var A_=Object.getPrototypeOf(Uint8Array),Sm="__proto__";function so(i,e=Cl){let t;if(Hs(i)){let n=i.find(s=>s!=null);if(Hs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=so(i[s],e)}else t=i.slice()}else if(i instanceof A_)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Sm&&(t[n]=so(i[n],e))}else t=i;return t}function gn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Sm&&(Cl(i[s])?gn(i[s],so(n[s])):i[s]=so(n[s]))}return i}var R_=0,C_=1,P_=2;function I_(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function L_(i,e){if(U_(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return F_(o[0])||(o=N_(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let c=i[o][0],l=c.length;for(let u=0;u<l;u++)t.add(c[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let u=a[l],d=Array(s).fill(void 0),h=e?e[o][l]:C_,f=[];for(let p=0;p<u.length;p++){let v=u[p],g=r.get(c[p]);v===null?h!=R_&&(d[g]=v,h==P_&&f.push(g)):d[g]=v}I_(d,f,s),n.push(d)}}return n}var D_=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function N_(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let c=0;c<t;c++)a[c]=o[n[c]];s.push(a)}return s}function U_(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function F_(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=$n(1,fi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var wm=["January","February","March","April","May","June","July","August","September","October","November","December"],Tm=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Em(i){return i.slice(0,3)}var O_=Tm.map(Em),B_=wm.map(Em),k_={MMMM:wm,MMM:B_,WWWW:Tm,WWW:O_};function ua(i){return(i<10?"0":"")+i}function z_(i){return(i<10?"00":i<100?"0":"")+i}var G_={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>ua(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ua(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>ua(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ua(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ua(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>z_(i.getMilliseconds())};function qh(i,e){e=e||k_;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?G_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var V_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function H_(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==V_?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Am=i=>i%1==0,Tl=[1,2,2.5,5],W_=ga(10,-32,0,Tl),Rm=ga(10,0,32,Tl),X_=Rm.filter(Am),br=W_.concat(Rm),Yh=`
`,Cm="{YYYY}",Yp=Yh+Cm,Pm="{M}/{D}",fa=Yh+Pm,yl=fa+"/{YY}",Im="{aa}",q_="{h}:{mm}",eo=q_+Im,$p=Yh+eo,Zp=":{ss}",Nt=null;function Lm(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,c=(i==1?ga(10,0,3,Tl).filter(Am):ga(10,-3,0,Tl)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,Cm,Nt,Nt,Nt,Nt,Nt,Nt,1],[s*28,"{MMM}",Yp,Nt,Nt,Nt,Nt,Nt,1],[s,Pm,Yp,Nt,Nt,Nt,Nt,Nt,1],[n,"{h}"+Im,yl,Nt,fa,Nt,Nt,Nt,1],[t,eo,yl,Nt,fa,Nt,Nt,Nt,1],[e,Zp,yl+" "+eo,Nt,fa+" "+eo,Nt,$p,Nt,1],[i,Zp+".{fff}",yl+" "+eo,Nt,fa+" "+eo,Nt,$p,Nt,1]];function u(d){return(h,f,p,v,g,m)=>{let y=[],A=g>=o,b=g>=r&&g<o,C=d(p),E=Wt(C*i,3),x=Eh(C.getFullYear(),A?0:C.getMonth(),b||A?1:C.getDate()),M=Wt(x*i,3);if(b||A){let U=b?g/r:0,I=A?g/o:0,D=E==M?E:Wt(Eh(x.getFullYear()+I,x.getMonth()+U,1)*i,3),G=new Date(yn(D/i)),H=G.getFullYear(),P=G.getMonth();for(let V=0;D<=v;V++){let z=Eh(H+I*V,P+U*V,1),N=z-d(Wt(z*i,3));D=Wt((+z+N)*i,3),D<=v&&y.push(D)}}else{let U=g>=s?s:g,I=fi(p)-fi(E),D=M+I+Rl(E-M,U);y.push(D);let G=d(D),H=G.getHours()+G.getMinutes()/t+G.getSeconds()/n,P=g/n,V=h.axes[f]._space,z=m/V;for(;D=Wt(D+g,i==1?0:3),!(D>v);)if(P>1){let N=fi(Wt(H+P,6))%24,$=d(D).getHours()-N;$>1&&($=-1),D-=$*n,H=(H+P)%24;let te=y[y.length-1];Wt((D-te)/g,3)*z>=.7&&y.push(D)}else y.push(D)}return y}}return[c,l,u]}var[Y_,$_,Z_]=Lm(1),[J_,K_,j_]=Lm(.001);ga(2,-53,53,[1]);function Jp(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function Kp(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],c,l,u,d,h,f;return n.map(p=>{let v=i(p),g=v.getFullYear(),m=v.getMonth(),y=v.getDate(),A=v.getHours(),b=v.getMinutes(),C=v.getSeconds(),E=g!=c&&a[2]||m!=l&&a[3]||y!=u&&a[4]||A!=d&&a[5]||b!=h&&a[6]||C!=f&&a[7]||a[1];return c=g,l=m,u=y,d=A,h=b,f=C,E(v)})}}function Q_(i,e){let t=qh(e);return(n,s,r,o,a)=>s.map(c=>t(i(c)))}function Eh(i,e,t){return new Date(i,e,t)}function jp(i,e){return e(i)}var ev="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Qp(i,e){return(t,n,s,r)=>r==null?zh:e(i(n))}function tv(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function nv(i,e){return i.series[e].fill(i,e)}var iv={show:!0,live:!0,isolate:!1,mount:M_,markers:{show:!0,width:2,stroke:tv,fill:nv,dash:"solid"},idx:null,idxs:null,values:[]};function sv(i,e){let t=i.cursor.points,n=wi(),s=t.size(i,e);$t(n,ha,s),$t(n,da,s);let r=s/-2;$t(n,"marginLeft",r),$t(n,"marginTop",r);let o=t.width(i,e,s);return o&&$t(n,"borderWidth",o),n}function rv(i,e){let t=i.series[e].points;return t._fill||t._stroke}function ov(i,e){let t=i.series[e].points;return t._stroke||t._fill}function av(i,e){return i.series[e].points.size}var Ah=[0,0];function lv(i,e,t){return Ah[0]=e,Ah[1]=t,Ah}function bl(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Rh(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var cv={show:!0,x:!0,y:!0,lock:!1,move:lv,points:{one:!1,show:sv,size:av,width:0,stroke:ov,fill:rv},bind:{mousedown:bl,mouseup:bl,click:bl,dblclick:bl,mousemove:Rh,mouseleave:Rh,mouseenter:Rh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Dm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},$h=gn({},Dm,{filter:vm}),Nm=gn({},$h,{size:10}),Um=gn({},Dm,{show:!1}),Zh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Fm="bold "+Zh,Om=1.5,em={show:!0,scale:"x",stroke:kh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Fm,side:2,grid:$h,ticks:Nm,border:Um,font:Zh,lineGap:Om,rotate:0},uv="Value",hv="Time",tm={show:!0,scale:"x",auto:!1,sorted:1,min:Ht,max:-Ht,idxs:[]};function dv(i,e,t,n,s){return e.map(r=>r==null?"":Wh(r))}function fv(i,e,t,n,s,r,o){let a=[],c=Ws.get(s)||0;t=o?t:Wt(Rl(t,s),c);for(let l=t;l<=n;l=Wt(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function Nh(i,e,t,n,s,r,o){let a=[],c=i.scales[i.axes[e].scale].log,l=c==10?fs:gm,u=fi(l(t));s=no(c,u),c==10&&(s=br[Ui(s,br)]);let d=t,h=s*c;c==10&&(h=br[Ui(h,br)]);do a.push(d),d=d+s,c==10&&!Ws.has(d)&&(d=Wt(d,Ws.get(s))),d>=h&&(s=d,h=s*c,c==10&&(h=br[Ui(h,br)]));while(d<=n);return a}function pv(i,e,t,n,s,r,o){let c=i.scales[i.axes[e].scale].asinh,l=n>c?Nh(i,e,$n(c,t),n,s):[c],u=n>=0&&t<=0?[0]:[];return(t<-c?Nh(i,e,$n(c,-n),-t,s):[c]).reverse().map(h=>-h).concat(u,l)}var Bm=/./,mv=/[12357]/,gv=/[125]/,nm=/1/,Uh=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function xv(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],c=i.valToPos,l=r._space,u=c(10,o),d=c(9,o)-u>=l?Bm:c(7,o)-u>=l?mv:c(5,o)-u>=l?gv:nm;if(d==nm){let h=bn(c(1,o)-u);if(h<l)return Uh(e.slice().reverse(),a.distr,d,Ti(l/h)).reverse()}return Uh(e,a.distr,d,1)}function _v(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,c=i.valToPos,l=bn(c(1,o)-c(2,o));return l<a?Uh(e.slice().reverse(),3,Bm,Ti(a/l)).reverse():e}function vv(i,e,t,n){return n==null?zh:e==null?"":Wh(e)}var im={show:!0,scale:"y",stroke:kh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Fm,side:3,grid:$h,ticks:Nm,border:Um,font:Zh,lineGap:Om,rotate:0};function yv(i,e){let t=3+(i||1)*2;return Wt(t*e,3)}function bv(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=bn(o-r),c=i.series[e],l=a/(c.points.space*Dt);return n[1]-n[0]<=l}var sm={scale:null,auto:!0,sorted:0,min:Ht,max:-Ht},km=(i,e,t,n,s)=>s,rm={show:!0,auto:!0,sorted:0,gaps:km,alpha:1,facets:[gn({},sm,{scale:"x"}),gn({},sm,{scale:"y"})]},om={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:km,alpha:1,points:{show:bv,filter:null},values:null,min:Ht,max:-Ht,idxs:[],path:null,clip:null};function Mv(i,e,t,n,s){return t/10}var zm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Sv=gn({},zm,{time:!1,ori:1}),am={};function Gm(i,e){let t=am[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,c,l)}},i!=null&&(am[i]=t)),t}var ro=1,Fh=2;function Tr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,p=a.width,v=a.height,g=i.valToPosH,m=i.valToPosV;return u.ori==0?t(s,c,l,u,d,g,m,h,f,p,v,Il,ao,Dl,Hm,Xm):t(s,c,l,u,d,m,g,f,h,v,p,Ll,lo,jh,Wm,qm)}function Jh(i,e){let t=0,n=0,s=Ct(i.bands,Xh);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function wv(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function ps(i,e,t,n,s,r){return Tr(i,e,(o,a,c,l,u,d,h,f,p,v,g)=>{let m=o.pxRound,y=l.dir*(l.ori==0?1:-1),A=l.ori==0?ao:lo,b,C;y==1?(b=t,C=n):(b=n,C=t);let E=m(d(a[b],l,v,f)),x=m(h(c[b],u,g,p)),M=m(d(a[C],l,v,f)),U=m(h(r==1?u.max:u.min,u,g,p)),I=new Path2D(s);return A(I,M,U),A(I,E,U),A(I,E,x),I})}function Pl(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?Dl:jh,c=t;for(let d=0;d<i.length;d++){let h=i[d];if(h[1]>h[0]){let f=h[0]-c;f>0&&a(o,c,n,f,n+r),c=h[1]}}let l=t+s-c,u=10;l>0&&a(o,c,n-u/2,l,n+r+u)}return o}function Tv(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function Kh(i,e,t,n,s,r,o){let a=[],c=i.length;for(let l=s==1?t:n;l>=t&&l<=n;l+=s)if(e[l]===null){let d=l,h=l;if(s==1)for(;++l<=n&&e[l]===null;)h=l;else for(;--l>=t&&e[l]===null;)h=l;let f=r(i[d]),p=h==d?f:r(i[h]),v=d-s;f=o<=0&&v>=0&&v<c?r(i[v]):f;let m=h+s;p=o>=0&&m>=0&&m<c?r(i[m]):p,p>=f&&a.push([f,p])}return a}function lm(i){return i==0?_m:i==1?yn:e=>yr(e,i)}function Vm(i){let e=i==0?Il:Ll,t=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,u=0)=>{l==0&&u==0?n(s,r,o,a,c):(l=Fi(l,a/2,c/2),u=Fi(u,a/2,c/2),e(s,r+l,o),t(s,r+a,o,r+a,o+c,l),t(s,r+a,o+c,r,o+c,u),t(s,r,o+c,r,o,u),t(s,r,o,r+a,o,l),s.closePath())}}var Il=(i,e,t)=>{i.moveTo(e,t)},Ll=(i,e,t)=>{i.moveTo(t,e)},ao=(i,e,t)=>{i.lineTo(e,t)},lo=(i,e,t)=>{i.lineTo(t,e)},Dl=Vm(0),jh=Vm(1),Hm=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},Wm=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Xm=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},qm=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Ym(i){return(e,t,n,s,r)=>Tr(e,t,(o,a,c,l,u,d,h,f,p,v,g)=>{let{pxRound:m,points:y}=o,A,b;l.ori==0?(A=Il,b=Hm):(A=Ll,b=Wm);let C=Wt(y.width*Dt,3),E=(y.size-y.width)/2*Dt,x=Wt(E*2,3),M=new Path2D,U=new Path2D,{left:I,top:D,width:G,height:H}=e.bbox;Dl(U,I-x,D-x,G+x*2,H+x*2);let P=V=>{if(c[V]!=null){let z=m(d(a[V],l,v,f)),N=m(h(c[V],u,g,p));A(M,z+E,N),b(M,z,N,E,0,Ml*2)}};if(r)r.forEach(P);else for(let V=n;V<=s;V++)P(V);return{stroke:C>0?M:null,fill:M,clip:U,flags:ro|Fh}})}function $m(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var Ev=$m(ao),Av=$m(lo);function Zm(i){let e=Ct(i?.alignGaps,0);return(t,n,s,r)=>Tr(t,n,(o,a,c,l,u,d,h,f,p,v,g)=>{[s,r]=El(c,s,r);let m=o.pxRound,y=H=>m(d(H,l,v,f)),A=H=>m(h(H,u,g,p)),b,C;l.ori==0?(b=ao,C=Ev):(b=lo,C=Av);let E=l.dir*(l.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ro},M=x.stroke,U=!1;if(r-s>=v*4){let H=de=>t.posToVal(de,l.key,!0),P=null,V=null,z,N,re,q=y(a[E==1?s:r]),$=y(a[s]),te=y(a[r]),ue=H(E==1?$+1:te-1);for(let de=E==1?s:r;de>=s&&de<=r;de+=E){let K=a[de],be=(E==1?K<ue:K>ue)?q:y(K),Pe=c[de];be==q?Pe!=null?(N=Pe,P==null?(b(M,be,A(N)),z=P=V=N):N<P?P=N:N>V&&(V=N)):Pe===null&&(U=!0):(P!=null&&C(M,q,A(P),A(V),A(z),A(N)),Pe!=null?(N=Pe,b(M,be,A(N)),P=V=z=N):(P=V=null,Pe===null&&(U=!0)),q=be,ue=H(q+E))}P!=null&&P!=V&&re!=q&&C(M,q,A(P),A(V),A(z),A(N))}else for(let H=E==1?s:r;H>=s&&H<=r;H+=E){let P=c[H];P===null?U=!0:P!=null&&b(M,y(a[H]),A(P))}let[D,G]=Jh(t,n);if(o.fill!=null||D!=0){let H=x.fill=new Path2D(M),P=o.fillTo(t,n,o.min,o.max,D),V=A(P),z=y(a[s]),N=y(a[r]);E==-1&&([N,z]=[z,N]),b(H,N,V),b(H,z,V)}if(!o.spanGaps){let H=[];U&&H.push(...Kh(a,c,s,r,E,y,e)),x.gaps=H=o.gaps(t,n,s,r,H),x.clip=Pl(H,l.ori,f,p,v,g)}return G!=0&&(x.band=G==2?[ps(t,n,s,r,M,-1),ps(t,n,s,r,M,1)]:ps(t,n,s,r,M,G)),x})}function Rv(i){let e=Ct(i.align,1),t=Ct(i.ascDesc,!1),n=Ct(i.alignGaps,0),s=Ct(i.extend,!1);return(r,o,a,c)=>Tr(r,o,(l,u,d,h,f,p,v,g,m,y,A)=>{[a,c]=El(d,a,c);let b=l.pxRound,{left:C,width:E}=r.bbox,x=$=>b(p($,h,y,g)),M=$=>b(v($,f,A,m)),U=h.ori==0?ao:lo,I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ro},D=I.stroke,G=h.dir*(h.ori==0?1:-1),H=M(d[G==1?a:c]),P=x(u[G==1?a:c]),V=P,z=P;s&&e==-1&&(z=C,U(D,z,H)),U(D,P,H);for(let $=G==1?a:c;$>=a&&$<=c;$+=G){let te=d[$];if(te==null)continue;let ue=x(u[$]),de=M(te);e==1?U(D,ue,H):U(D,V,de),U(D,ue,de),H=de,V=ue}let N=V;s&&e==1&&(N=C+E,U(D,N,H));let[re,q]=Jh(r,o);if(l.fill!=null||re!=0){let $=I.fill=new Path2D(D),te=l.fillTo(r,o,l.min,l.max,re),ue=M(te);U($,N,ue),U($,z,ue)}if(!l.spanGaps){let $=[];$.push(...Kh(u,d,a,c,G,x,n));let te=l.width*Dt/2,ue=t||e==1?te:-te,de=t||e==-1?-te:te;$.forEach(K=>{K[0]+=ue,K[1]+=de}),I.gaps=$=l.gaps(r,o,a,c,$),I.clip=Pl($,h.ori,g,m,y,A)}return q!=0&&(I.band=q==2?[ps(r,o,a,c,D,-1),ps(r,o,a,c,D,1)]:ps(r,o,a,c,D,q)),I})}function cm(i,e,t,n,s,r,o=Ht){if(i.length>1){let a=null;for(let c=0,l=1/0;c<i.length;c++)if(e[c]!==void 0){if(a!=null){let u=bn(i[c]-i[a]);u<l&&(l=u,o=bn(t(i[c],n,s,r)-t(i[a],n,s,r)))}a=c}}return o}function Cv(i){i=i||ma;let e=Ct(i.size,[.6,Ht,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Tt(s),o=1-e[0],a=Ct(e[1],Ht),c=Ct(e[2],1),l=Ct(i.disp,ma),u=Ct(i.each,f=>{}),{fill:d,stroke:h}=l;return(f,p,v,g)=>Tr(f,p,(m,y,A,b,C,E,x,M,U,I,D)=>{let G=m.pxRound,H=t,P=n*Dt,V=a*Dt,z=c*Dt,N,re;b.ori==0?[N,re]=r(f,p):[re,N]=r(f,p);let q=b.dir*(b.ori==0?1:-1),$=b.ori==0?Dl:jh,te=b.ori==0?u:(De,et,ht,we,It,Ye,Ke)=>{u(De,et,ht,It,we,Ke,Ye)},ue=Ct(f.bands,Xh).find(De=>De.series[0]==p),de=ue!=null?ue.dir:0,K=m.fillTo(f,p,m.min,m.max,de),xe=G(x(K,C,D,U)),be,Pe,Ee,Ve=I,Qe=G(m.width*Dt),Ge=!1,ct=null,ft=null,tt=null,ye=null;d!=null&&(Qe==0||h!=null)&&(Ge=!0,ct=d.values(f,p,v,g),ft=new Map,new Set(ct).forEach(De=>{De!=null&&ft.set(De,new Path2D)}),Qe>0&&(tt=h.values(f,p,v,g),ye=new Map,new Set(tt).forEach(De=>{De!=null&&ye.set(De,new Path2D)})));let{x0:me,size:Ne}=l;if(me!=null&&Ne!=null){H=1,y=me.values(f,p,v,g),me.unit==2&&(y=y.map(ht=>f.posToVal(M+ht*I,b.key,!0)));let De=Ne.values(f,p,v,g);Ne.unit==2?Pe=De[0]*I:Pe=E(De[0],b,I,M)-E(0,b,I,M),Ve=cm(y,A,E,b,I,M,Ve),Ee=Ve-Pe+P}else Ve=cm(y,A,E,b,I,M,Ve),Ee=Ve*o+P,Pe=Ve-Ee;Ee<1&&(Ee=0),Qe>=Pe/2&&(Qe=0),Ee<5&&(G=_m);let qe=Ee>0,nt=Ve-Ee-(qe?Qe:0);Pe=G(Dh(nt,z,V)),be=(H==0?Pe/2:H==q?0:Pe)-H*q*((H==0?P/2:0)+(qe?Qe/2:0));let ut={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Jt=Ge?null:new Path2D,Pt=null;if(ue!=null)Pt=f.data[ue.series[1]];else{let{y0:De,y1:et}=l;De!=null&&et!=null&&(A=et.values(f,p,v,g),Pt=De.values(f,p,v,g))}let kt=N*Pe,B=re*Pe;for(let De=q==1?v:g;De>=v&&De<=g;De+=q){let et=A[De];if(et==null)continue;if(Pt!=null){let Y=Pt[De]??0;if(et-Y==0)continue;xe=x(Y,C,D,U)}let ht=b.distr!=2||l!=null?y[De]:De,we=E(ht,b,I,M),It=x(Ct(et,K),C,D,U),Ye=G(we-be),Ke=G($n(It,xe)),R=G(Fi(It,xe)),S=Ke-R;if(et!=null){let Y=et<0?B:kt,he=et<0?kt:B;Ge?(Qe>0&&tt[De]!=null&&$(ye.get(tt[De]),Ye,R+fi(Qe/2),Pe,$n(0,S-Qe),Y,he),ct[De]!=null&&$(ft.get(ct[De]),Ye,R+fi(Qe/2),Pe,$n(0,S-Qe),Y,he)):$(Jt,Ye,R+fi(Qe/2),Pe,$n(0,S-Qe),Y,he),te(f,p,De,Ye-Qe/2,R,Pe+Qe,S)}}return Qe>0?ut.stroke=Ge?ye:Jt:Ge||(ut._fill=m.width==0?m._fill:m._stroke??m._fill,ut.width=0),ut.fill=Ge?ft:Jt,ut})}function Pv(i,e){let t=Ct(e?.alignGaps,0);return(n,s,r,o)=>Tr(n,s,(a,c,l,u,d,h,f,p,v,g,m)=>{[r,o]=El(l,r,o);let y=a.pxRound,A=N=>y(h(N,u,g,p)),b=N=>y(f(N,d,m,v)),C,E,x;u.ori==0?(C=Il,x=ao,E=Xm):(C=Ll,x=lo,E=qm);let M=u.dir*(u.ori==0?1:-1),U=A(c[M==1?r:o]),I=U,D=[],G=[];for(let N=M==1?r:o;N>=r&&N<=o;N+=M)if(l[N]!=null){let q=c[N],$=A(q);D.push(I=$),G.push(b(l[N]))}let H={stroke:i(D,G,C,x,E,y),fill:null,clip:null,band:null,gaps:null,flags:ro},P=H.stroke,[V,z]=Jh(n,s);if(a.fill!=null||V!=0){let N=H.fill=new Path2D(P),re=a.fillTo(n,s,a.min,a.max,V),q=b(re);x(N,I,q),x(N,U,q)}if(!a.spanGaps){let N=[];N.push(...Kh(c,l,r,o,M,A,t)),H.gaps=N=a.gaps(n,s,r,o,N),H.clip=Pl(N,u.ori,p,v,g,m)}return z!=0&&(H.band=z==2?[ps(n,s,r,o,P,-1),ps(n,s,r,o,P,1)]:ps(n,s,r,o,P,z)),H})}function Iv(i){return Pv(Lv,i)}function Lv(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let c=Array(o),l=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],d[h]=i[h+1]-i[h],l[h]=u[h]/d[h];c[0]=l[0];for(let h=1;h<o-1;h++)l[h]===0||l[h-1]===0||l[h-1]>0!=l[h]>0?c[h]=0:(c[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/l[h-1]+(d[h]+2*d[h-1])/l[h]),isFinite(c[h])||(c[h]=0));c[o-1]=l[o-2];for(let h=0;h<o-1;h++)s(a,i[h]+d[h]/3,e[h]+c[h]*d[h]/3,i[h+1]-d[h]/3,e[h+1]-c[h+1]*d[h]/3,i[h+1],e[h+1])}return a}var Oh=new Set;function um(){for(let i of Oh)i.syncRect(!0)}oo&&(Sr(d_,to,um),Sr(f_,to,um,!0),Sr(Sl,to,()=>{In.pxRatio=Dt}));var Dv=Zm(),Nv=Ym();function hm(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>Bh(r,o,e,t))}function Uv(i,e){return i.map((t,n)=>n==0?{}:gn({},e,t))}function Bh(i,e,t,n){return gn({},e==0?t:n,i)}function Jm(i,e,t){return e==null?io:[e,t]}var Fv=Jm;function Ov(i,e,t){return e==null?io:wl(e,t,Hh,!0)}function Km(i,e,t,n){return e==null?io:Al(e,t,i.scales[n].log,!1)}var Bv=Km;function jm(i,e,t,n){return e==null?io:Vh(e,t,i.scales[n].log,!1)}var kv=jm;function zv(i,e,t,n,s){let r=$n(Hp(i),Hp(e)),o=e-i,a=Ui(s/n*o,t);do{let c=t[a],l=n*c/o;if(l>=s&&r+(c<5?Ws.get(c):0)<=17)return[c,l]}while(++a<t.length);return[0,0]}function dm(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=yn((t=+s)*Dt))+"px"),[i,e,t]}function Gv(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Wt(e[2]*Dt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function In(i,e,t){let n={mode:Ct(i.mode,1)},s=n.mode;function r(_,w,L,F){let X=w.valToPct(_);return F+L*(w.dir==-1?1-X:X)}function o(_,w,L,F){let X=w.valToPct(_);return F+L*(w.dir==-1?X:1-X)}function a(_,w,L,F){return w.ori==0?r(_,w,L,F):o(_,w,L,F)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=wi($x);if(i.id!=null&&(l.id=i.id),di(l,i.class),i.title){let _=wi(Kx,l);_.textContent=i.title}let u=Ni("canvas"),d=n.ctx=u.getContext("2d"),h=wi(jx,l);Sr("click",h,_=>{_.target===p&&(Xt!=Vr||Kt!=Hr)&&Fn.click(n,_)},!0);let f=n.under=wi(Qx,h);h.appendChild(u);let p=n.over=wi(e_,h);i=so(i);let v=+Ct(i.pxAlign,1),g=lm(v);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});let m=i.ms||.001,y=n.series=s==1?hm(i.series||[],tm,om,!1):Uv(i.series||[null],rm),A=n.axes=hm(i.axes||[],em,im,!0),b=n.scales={},C=n.bands=i.bands||[];C.forEach(_=>{_.fill=Tt(_.fill||null),_.dir=Ct(_.dir,-1)});let E=s==2?y[1].facets[0].scale:y[0].scale,x={axes:us,series:bt},M=(i.drawOrder||["axes","series"]).map(_=>x[_]);function U(_){let w=_.distr==3?L=>fs(L>0?L:_.clamp(n,L,_.min,_.max,_.key)):_.distr==4?L=>Th(L,_.asinh):_.distr==100?L=>_.fwd(L):L=>L;return L=>{let F=w(L),{_min:X,_max:Q}=_,fe=Q-X;return(F-X)/fe}}function I(_){let w=b[_];if(w==null){let L=(i.scales||ma)[_]||ma;if(L.from!=null){I(L.from);let F=gn({},b[L.from],L,{key:_});F.valToPct=U(F),b[_]=F}else{w=b[_]=gn({},_==E?zm:Sv,L),w.key=_;let F=w.time,X=w.range,Q=Hs(X);if((_!=E||s==2&&!F)&&(Q&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?zp:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?zp:{mode:1,hard:X[1],soft:X[1]}},Q=!1),!Q&&Cl(X))){let fe=X;X=(ve,Ce,ke)=>Ce==null?io:wl(Ce,ke,fe)}w.range=Tt(X||(F?Fv:_==E?w.distr==3?Bv:w.distr==4?kv:Jm:w.distr==3?Km:w.distr==4?jm:Ov)),w.auto=Tt(Q?!1:w.auto),w.clamp=Tt(w.clamp||Mv),w._min=w._max=null,w.valToPct=U(w)}}}I("x"),I("y"),s==1&&y.forEach(_=>{I(_.scale)}),A.forEach(_=>{I(_.scale)});for(let _ in i.scales)I(_);let D=b[E],G=D.distr,H,P;D.ori==0?(di(l,Zx),H=r,P=o):(di(l,Jx),H=o,P=r);let V={};for(let _ in b){let w=b[_];(w.min!=null||w.max!=null)&&(V[_]={min:w.min,max:w.max},w.min=w.max=null)}let z=i.tzDate||(_=>new Date(yn(_/m))),N=i.fmtDate||qh,re=m==1?Z_(z):j_(z),q=Kp(z,Jp(m==1?$_:K_,N)),$=Qp(z,jp(ev,N)),te=[],ue=n.legend=gn({},iv,i.legend),de=n.cursor=gn({},cv,{drag:{y:s==2}},i.cursor),K=ue.show,xe=de.show,be=ue.markers;ue.idxs=te,be.width=Tt(be.width),be.dash=Tt(be.dash),be.stroke=Tt(be.stroke),be.fill=Tt(be.fill);let Pe,Ee,Ve,Qe=[],Ge=[],ct,ft=!1,tt={};if(ue.live){let _=y[1]?y[1].values:null;ft=_!=null,ct=ft?_(n,1,0):{_:0};for(let w in ct)tt[w]=zh}if(K)if(Pe=Ni("table",o_,l),Ve=Ni("tbody",null,Pe),ue.mount(n,Pe),ft){Ee=Ni("thead",null,Pe,Ve);let _=Ni("tr",null,Ee);Ni("th",null,_);for(var ye in ct)Ni("th",Ap,_).textContent=ye}else di(Pe,l_),ue.live&&di(Pe,a_);let me={show:!0},Ne={show:!1};function qe(_,w){if(w==0&&(ft||!ue.live||s==2))return io;let L=[],F=Ni("tr",c_,Ve,Ve.childNodes[w]);di(F,_.class),_.show||di(F,Mr);let X=Ni("th",null,F);if(be.show){let ve=wi(u_,X);if(w>0){let Ce=be.width(n,w);Ce&&(ve.style.border=Ce+"px "+be.dash(n,w)+" "+be.stroke(n,w)),ve.style.background=be.fill(n,w)}}let Q=wi(Ap,X);_.label instanceof HTMLElement?Q.appendChild(_.label):Q.textContent=_.label,w>0&&(be.show||(Q.style.color=_.width>0?be.stroke(n,w):be.fill(n,w)),ut("click",X,ve=>{if(de._lock)return;it(ve);let Ce=y.indexOf(_);if((ve.ctrlKey||ve.metaKey)!=ue.isolate){let ke=y.some((ze,Xe)=>Xe>0&&Xe!=Ce&&ze.show);y.forEach((ze,Xe)=>{Xe>0&&Zi(Xe,ke?Xe==Ce?me:Ne:me,!0,mn.setSeries)})}else Zi(Ce,{show:!_.show},!0,mn.setSeries)},!1),st&&ut(Ip,X,ve=>{de._lock||(it(ve),Zi(y.indexOf(_),Xr,!0,mn.setSeries))},!1));for(var fe in ct){let ve=Ni("td",h_,F);ve.textContent="--",L.push(ve)}return[F,L]}let nt=new Map;function ut(_,w,L,F=!0){let X=nt.get(w)||{},Q=de.bind[_](n,w,L,F);Q&&(Sr(_,w,X[_]=Q),nt.set(w,X))}function Jt(_,w,L){let F=nt.get(w)||{};for(let X in F)(_==null||X==_)&&(Lh(X,w,F[X]),delete F[X]);_==null&&nt.delete(w)}let Pt=0,kt=0,B=0,De=0,et=0,ht=0,we=et,It=ht,Ye=B,Ke=De,R=0,S=0,Y=0,he=0;n.bbox={};let ce=!1,Te=!1,Me=!1,se=!1,oe=!1,_e=!1;function k(_,w,L){(L||_!=n.width||w!=n.height)&&le(_,w),gt(!1),Me=!0,Te=!0,kn()}function le(_,w){n.width=Pt=B=_,n.height=kt=De=w,et=ht=0,Ae(),Je();let L=n.bbox;R=L.left=yr(et*Dt,.5),S=L.top=yr(ht*Dt,.5),Y=L.width=yr(B*Dt,.5),he=L.height=yr(De*Dt,.5)}let ae=3;function Re(){let _=!1,w=0;for(;!_;){w++;let L=kr(w),F=$i(w);_=w==ae||L&&F,_||(le(n.width,n.height),Te=!0)}}function Se({width:_,height:w}){k(_,w)}n.setSize=Se;function Ae(){let _=!1,w=!1,L=!1,F=!1;A.forEach((X,Q)=>{if(X.show&&X._show){let{side:fe,_size:ve}=X,Ce=fe%2,ke=X.label!=null?X.labelSize:0,ze=ve+ke;ze>0&&(Ce?(B-=ze,fe==3?(et+=ze,F=!0):L=!0):(De-=ze,fe==0?(ht+=ze,_=!0):w=!0))}}),zt[0]=_,zt[1]=L,zt[2]=w,zt[3]=F,B-=Pi[1]+Pi[3],et+=Pi[3],De-=Pi[2]+Pi[0],ht+=Pi[0]}function Je(){let _=et+B,w=ht+De,L=et,F=ht;function X(Q,fe){switch(Q){case 1:return _+=fe,_-fe;case 2:return w+=fe,w-fe;case 3:return L-=fe,L+fe;case 0:return F-=fe,F+fe}}A.forEach((Q,fe)=>{if(Q.show&&Q._show){let ve=Q.side;Q._pos=X(ve,Q._size),Q.label!=null&&(Q._lpos=X(ve,Q.labelSize))}})}if(de.dataIdx==null){let _=de.hover,w=_.skip=new Set(_.skip??[]);w.add(void 0);let L=_.prox=Tt(_.prox),F=_.bias??=0;de.dataIdx=(X,Q,fe,ve)=>{if(Q==0)return fe;let Ce=fe,ke=L(X,Q,fe,ve)??Ht,ze=ke>=0&&ke<Ht,Xe=D.ori==0?B:De,pt=de.left,Lt=e[0],Rt=e[Q];if(w.has(Rt[fe])){Ce=null;let Mt=null,rt=null,je;if(F==0||F==-1)for(je=fe;Mt==null&&je-- >0;)w.has(Rt[je])||(Mt=je);if(F==0||F==1)for(je=fe;rt==null&&je++<Rt.length;)w.has(Rt[je])||(rt=je);if(Mt!=null||rt!=null)if(ze){let Yt=Mt==null?-1/0:H(Lt[Mt],D,Xe,0),an=rt==null?1/0:H(Lt[rt],D,Xe,0),Cn=pt-Yt,Gt=an-pt;Cn<=Gt?Cn<=ke&&(Ce=Mt):Gt<=ke&&(Ce=rt)}else Ce=rt==null?Mt:Mt==null?rt:fe-Mt<=rt-fe?Mt:rt}else ze&&bn(pt-H(Lt[fe],D,Xe,0))>ke&&(Ce=null);return Ce}}let it=_=>{de.event=_};de.idxs=te,de._lock=!1;let pe=de.points;pe.show=Tt(pe.show),pe.size=Tt(pe.size),pe.stroke=Tt(pe.stroke),pe.width=Tt(pe.width),pe.fill=Tt(pe.fill);let He=n.focus=gn({},i.focus||{alpha:.3},de.focus),st=He.prox>=0,O=st&&pe.one,ie=[],ge=[],Be=[];function _t(_,w){let L=pe.show(n,w);if(L instanceof HTMLElement)return di(L,r_),di(L,_.class),Qi(L,-10,-10,B,De),p.insertBefore(L,ie[w]),L}function mt(_,w){if(s==1||w>0){let L=s==1&&b[_.scale].time,F=_.value;_.value=L?qp(F)?Qp(z,jp(F,N)):F||$:F||vv,_.label=_.label||(L?hv:uv)}if(O||w>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Dv||S_,_.fillTo=Tt(_.fillTo||wv),_.pxAlign=+Ct(_.pxAlign,v),_.pxRound=lm(_.pxAlign),_.stroke=Tt(_.stroke||null),_.fill=Tt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let L=yv($n(1,_.width),1),F=_.points=gn({},{size:L,width:$n(1,L*.2),stroke:_.stroke,space:L*2,paths:Nv,_stroke:null,_fill:null},_.points);F.show=Tt(F.show),F.filter=Tt(F.filter),F.fill=Tt(F.fill),F.stroke=Tt(F.stroke),F.paths=Tt(F.paths),F.pxAlign=_.pxAlign}if(K){let L=qe(_,w);Qe.splice(w,0,L[0]),Ge.splice(w,0,L[1]),ue.values.push(null)}if(xe){te.splice(w,0,null);let L=null;O?w==0&&(L=_t(_,w)):w>0&&(L=_t(_,w)),ie.splice(w,0,L),ge.splice(w,0,0),Be.splice(w,0,0)}Rn("addSeries",w)}function sn(_,w){w=w??y.length,_=s==1?Bh(_,w,tm,om):Bh(_,w,{},rm),y.splice(w,0,_),mt(y[w],w)}n.addSeries=sn;function Tn(_){if(y.splice(_,1),K){ue.values.splice(_,1),Ge.splice(_,1);let w=Qe.splice(_,1)[0];Jt(null,w.firstChild),w.remove()}xe&&(te.splice(_,1),ie.splice(_,1)[0].remove(),ge.splice(_,1),Be.splice(_,1)),Rn("delSeries",_)}n.delSeries=Tn;let zt=[!1,!1,!1,!1];function Un(_,w){if(_._show=_.show,_.show){let L=_.side%2,F=b[_.scale];F==null&&(_.scale=L?y[1].scale:E,F=b[_.scale]);let X=F.time;_.size=Tt(_.size),_.space=Tt(_.space),_.rotate=Tt(_.rotate),Hs(_.incrs)&&_.incrs.forEach(fe=>{!Ws.has(fe)&&Ws.set(fe,bm(fe))}),_.incrs=Tt(_.incrs||(F.distr==2?X_:X?m==1?Y_:J_:br)),_.splits=Tt(_.splits||(X&&F.distr==1?re:F.distr==3?Nh:F.distr==4?pv:fv)),_.stroke=Tt(_.stroke),_.grid.stroke=Tt(_.grid.stroke),_.ticks.stroke=Tt(_.ticks.stroke),_.border.stroke=Tt(_.border.stroke);let Q=_.values;_.values=Hs(Q)&&!Hs(Q[0])?Tt(Q):X?Hs(Q)?Kp(z,Jp(Q,N)):qp(Q)?Q_(z,Q):Q||q:Q||dv,_.filter=Tt(_.filter||(F.distr>=3&&F.log==10?xv:F.distr==3&&F.log==2?_v:vm)),_.font=dm(_.font),_.labelFont=dm(_.labelFont),_._size=_.size(n,null,w,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(zt[w]=!0,_._el=wi(t_,h))}}function Bn(_,w,L,F){let[X,Q,fe,ve]=L,Ce=w%2,ke=0;return Ce==0&&(ve||Q)&&(ke=w==0&&!X||w==2&&!fe?yn(em.size/3):0),Ce==1&&(X||fe)&&(ke=w==1&&!Q||w==3&&!ve?yn(im.size/2):0),ke}let Rs=n.padding=(i.padding||[Bn,Bn,Bn,Bn]).map(_=>Tt(Ct(_,Bn))),Pi=n._padding=Rs.map((_,w)=>_(n,w,zt,0)),rn,un=null,hn=null,Yi=s==1?y[0].idxs:null,ri=null,Cs=!1;function Ho(_,w){if(e=_??[],n.data=n._data=e,s==2){rn=0;for(let L=1;L<y.length;L++)rn+=e[L][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ri=e[0],rn=ri.length;let L=e;if(G==2){L=e.slice();let F=L[0]=Array(rn);for(let X=0;X<rn;X++)F[X]=X}n._data=e=L}if(gt(!0),Rn("setData"),G==2&&(Me=!0),w!==!1){let L=D;L.auto(n,Cs)?Wo():Ls(E,L.min,L.max),se=se||de.left>=0,_e=!0,kn()}}n.setData=Ho;function Wo(){Cs=!0;let _,w;s==1&&(rn>0?(un=Yi[0]=0,hn=Yi[1]=rn-1,_=e[0][un],w=e[0][hn],G==2?(_=un,w=hn):_==w&&(G==3?[_,w]=Al(_,_,D.log,!1):G==4?[_,w]=Vh(_,_,D.log,!1):D.time?w=_+yn(86400/m):[_,w]=wl(_,w,Hh,!0))):(un=Yi[0]=_=null,hn=Yi[1]=w=null)),Ls(E,_,w)}let Or,Ps,Br,T,W,ne,Z,j,Ie,Ue;function Le(_,w,L,F,X,Q){_??=Cp,L??=Xh,F??="butt",X??=Cp,Q??="round",_!=Or&&(d.strokeStyle=Or=_),X!=Ps&&(d.fillStyle=Ps=X),w!=Br&&(d.lineWidth=Br=w),Q!=W&&(d.lineJoin=W=Q),F!=ne&&(d.lineCap=ne=F),L!=T&&d.setLineDash(T=L)}function Fe(_,w,L,F){w!=Ps&&(d.fillStyle=Ps=w),_!=Z&&(d.font=Z=_),L!=j&&(d.textAlign=j=L),F!=Ie&&(d.textBaseline=Ie=F)}function Ze(_,w,L,F,X=0){if(F.length>0&&_.auto(n,Cs)&&(w==null||w.min==null)){let Q=Ct(un,0),fe=Ct(hn,F.length-1),ve=L.min==null?x_(F,Q,fe,X,_.distr==3):[L.min,L.max];_.min=Fi(_.min,L.min=ve[0]),_.max=$n(_.max,L.max=ve[1])}}let at={min:null,max:null};function yt(){for(let F in b){let X=b[F];V[F]==null&&(X.min==null||V[E]!=null&&X.auto(n,Cs))&&(V[F]=at)}for(let F in b){let X=b[F];V[F]==null&&X.from!=null&&V[X.from]!=null&&(V[F]=at)}V[E]!=null&&gt(!0);let _={};for(let F in V){let X=V[F];if(X!=null){let Q=_[F]=so(b[F],E_);if(X.min!=null)gn(Q,X);else if(F!=E||s==2)if(rn==0&&Q.from==null){let fe=Q.range(n,null,null,F);Q.min=fe[0],Q.max=fe[1]}else Q.min=Ht,Q.max=-Ht}}if(rn>0){y.forEach((F,X)=>{if(s==1){let Q=F.scale,fe=V[Q];if(fe==null)return;let ve=_[Q];if(X==0){let Ce=ve.range(n,ve.min,ve.max,Q);ve.min=Ce[0],ve.max=Ce[1],un=Ui(ve.min,e[0]),hn=Ui(ve.max,e[0]),hn-un>1&&(e[0][un]<ve.min&&un++,e[0][hn]>ve.max&&hn--),F.min=ri[un],F.max=ri[hn]}else F.show&&F.auto&&Ze(ve,fe,F,e[X],F.sorted);F.idxs[0]=un,F.idxs[1]=hn}else if(X>0&&F.show&&F.auto){let[Q,fe]=F.facets,ve=Q.scale,Ce=fe.scale,[ke,ze]=e[X],Xe=_[ve],pt=_[Ce];Xe!=null&&Ze(Xe,V[ve],Q,ke,Q.sorted),pt!=null&&Ze(pt,V[Ce],fe,ze,fe.sorted),F.min=fe.min,F.max=fe.max}});for(let F in _){let X=_[F],Q=V[F];if(X.from==null&&(Q==null||Q.min==null)){let fe=X.range(n,X.min==Ht?null:X.min,X.max==-Ht?null:X.max,F);X.min=fe[0],X.max=fe[1]}}}for(let F in _){let X=_[F];if(X.from!=null){let Q=_[X.from];if(Q.min==null)X.min=X.max=null;else{let fe=X.range(n,Q.min,Q.max,F);X.min=fe[0],X.max=fe[1]}}}let w={},L=!1;for(let F in _){let X=_[F],Q=b[F];if(Q.min!=X.min||Q.max!=X.max){Q.min=X.min,Q.max=X.max;let fe=Q.distr;Q._min=fe==3?fs(Q.min):fe==4?Th(Q.min,Q.asinh):fe==100?Q.fwd(Q.min):Q.min,Q._max=fe==3?fs(Q.max):fe==4?Th(Q.max,Q.asinh):fe==100?Q.fwd(Q.max):Q.max,w[F]=L=!0}}if(L){y.forEach((F,X)=>{s==2?X>0&&w.y&&(F._paths=null):w[F.scale]&&(F._paths=null)});for(let F in w)Me=!0,Rn("setScale",F);xe&&de.left>=0&&(se=_e=!0)}for(let F in V)V[F]=null}function $e(_){let w=Dh(un-1,0,rn-1),L=Dh(hn+1,0,rn-1);for(;_[w]==null&&w>0;)w--;for(;_[L]==null&&L<rn-1;)L++;return[w,L]}function bt(){if(rn>0){let _=y.some(w=>w._focus)&&Ue!=He.alpha;_&&(d.globalAlpha=Ue=He.alpha),y.forEach((w,L)=>{if(L>0&&w.show&&(nn(L,!1),nn(L,!0),w._paths==null)){let F=Ue;Ue!=w.alpha&&(d.globalAlpha=Ue=w.alpha);let X=s==2?[0,e[L][0].length-1]:$e(e[L]);w._paths=w.paths(n,L,X[0],X[1]),Ue!=F&&(d.globalAlpha=Ue=F)}}),y.forEach((w,L)=>{if(L>0&&w.show){let F=Ue;Ue!=w.alpha&&(d.globalAlpha=Ue=w.alpha),w._paths!=null&&Ft(L,!1);{let X=w._paths!=null?w._paths.gaps:null,Q=w.points.show(n,L,un,hn,X),fe=w.points.filter(n,L,Q,X);(Q||fe)&&(w.points._paths=w.points.paths(n,L,un,hn,fe),Ft(L,!0))}Ue!=F&&(d.globalAlpha=Ue=F),Rn("drawSeries",L)}}),_&&(d.globalAlpha=Ue=1)}}function nn(_,w){let L=w?y[_].points:y[_];L._stroke=L.stroke(n,_),L._fill=L.fill(n,_)}function Ft(_,w){let L=w?y[_].points:y[_],{stroke:F,fill:X,clip:Q,flags:fe,_stroke:ve=L._stroke,_fill:Ce=L._fill,_width:ke=L.width}=L._paths;ke=Wt(ke*Dt,3);let ze=null,Xe=ke%2/2;w&&Ce==null&&(Ce=ke>0?"#fff":ve);let pt=L.pxAlign==1&&Xe>0;if(pt&&d.translate(Xe,Xe),!w){let Lt=R-ke/2,Rt=S-ke/2,Mt=Y+ke,rt=he+ke;ze=new Path2D,ze.rect(Lt,Rt,Mt,rt)}w?We(ve,ke,L.dash,L.cap,Ce,F,X,fe,Q):Ot(_,ve,ke,L.dash,L.cap,Ce,F,X,fe,ze,Q),pt&&d.translate(-Xe,-Xe)}function Ot(_,w,L,F,X,Q,fe,ve,Ce,ke,ze){let Xe=!1;Ce!=0&&C.forEach((pt,Lt)=>{if(pt.series[0]==_){let Rt=y[pt.series[1]],Mt=e[pt.series[1]],rt=(Rt._paths||ma).band;Hs(rt)&&(rt=pt.dir==1?rt[0]:rt[1]);let je,Yt=null;Rt.show&&rt&&v_(Mt,un,hn)?(Yt=pt.fill(n,Lt)||Q,je=Rt._paths.clip):rt=null,We(w,L,F,X,Yt,fe,ve,Ce,ke,ze,je,rt),Xe=!0}}),Xe||We(w,L,F,X,Q,fe,ve,Ce,ke,ze)}let _n=ro|Fh;function We(_,w,L,F,X,Q,fe,ve,Ce,ke,ze,Xe){Le(_,w,L,F,X),(Ce||ke||Xe)&&(d.save(),Ce&&d.clip(Ce),ke&&d.clip(ke)),Xe?(ve&_n)==_n?(d.clip(Xe),ze&&d.clip(ze),wt(X,fe),dn(_,Q,w)):ve&Fh?(wt(X,fe),d.clip(Xe),dn(_,Q,w)):ve&ro&&(d.save(),d.clip(Xe),ze&&d.clip(ze),wt(X,fe),d.restore(),dn(_,Q,w)):(wt(X,fe),dn(_,Q,w)),(Ce||ke||Xe)&&d.restore()}function dn(_,w,L){L>0&&(w instanceof Map?w.forEach((F,X)=>{d.strokeStyle=Or=X,d.stroke(F)}):w!=null&&_&&d.stroke(w))}function wt(_,w){w instanceof Map?w.forEach((L,F)=>{d.fillStyle=Ps=F,d.fill(L)}):w!=null&&_&&d.fill(w)}function cs(_,w,L,F){let X=A[_],Q;if(F<=0)Q=[0,0];else{let fe=X._space=X.space(n,_,w,L,F),ve=X._incrs=X.incrs(n,_,w,L,F,fe);Q=zv(w,L,ve,F,fe)}return X._found=Q}function fn(_,w,L,F,X,Q,fe,ve,Ce,ke){let ze=fe%2/2;v==1&&d.translate(ze,ze),Le(ve,fe,Ce,ke,ve),d.beginPath();let Xe,pt,Lt,Rt,Mt=X+(F==0||F==3?-Q:Q);L==0?(pt=X,Rt=Mt):(Xe=X,Lt=Mt);for(let rt=0;rt<_.length;rt++)w[rt]!=null&&(L==0?Xe=Lt=_[rt]:pt=Rt=_[rt],d.moveTo(Xe,pt),d.lineTo(Lt,Rt));d.stroke(),v==1&&d.translate(-ze,-ze)}function kr(_){let w=!0;return A.forEach((L,F)=>{if(!L.show)return;let X=b[L.scale];if(X.min==null){L._show&&(w=!1,L._show=!1,gt(!1));return}else L._show||(w=!1,L._show=!0,gt(!1));let Q=L.side,fe=Q%2,{min:ve,max:Ce}=X,[ke,ze]=cs(F,ve,Ce,fe==0?B:De);if(ze==0)return;let Xe=X.distr==2,pt=L._splits=L.splits(n,F,ve,Ce,ke,ze,Xe),Lt=X.distr==2?pt.map(je=>ri[je]):pt,Rt=X.distr==2?ri[pt[1]]-ri[pt[0]]:ke,Mt=L._values=L.values(n,L.filter(n,Lt,F,ze,Rt),F,ze,Rt);L._rotate=Q==2?L.rotate(n,Mt,F,ze):0;let rt=L._size;L._size=Ti(L.size(n,Mt,F,_)),rt!=null&&L._size!=rt&&(w=!1)}),w}function $i(_){let w=!0;return Rs.forEach((L,F)=>{let X=L(n,F,zt,_);X!=Pi[F]&&(w=!1),Pi[F]=X}),w}function us(){for(let _=0;_<A.length;_++){let w=A[_];if(!w.show||!w._show)continue;let L=w.side,F=L%2,X,Q,fe=w.stroke(n,_),ve=L==0||L==3?-1:1,[Ce,ke]=w._found;if(w.label!=null){let qn=w.labelGap*ve,li=yn((w._lpos+qn)*Dt);Fe(w.labelFont[0],fe,"center",L==2?"top":Rp),d.save(),F==1?(X=Q=0,d.translate(li,yn(S+he/2)),d.rotate((L==3?-Ml:Ml)/2)):(X=yn(R+Y/2),Q=li);let ur=xm(w.label)?w.label(n,_,Ce,ke):w.label;d.fillText(ur,X,Q),d.restore()}if(ke==0)continue;let ze=b[w.scale],Xe=F==0?Y:he,pt=F==0?R:S,Lt=w._splits,Rt=ze.distr==2?Lt.map(qn=>ri[qn]):Lt,Mt=ze.distr==2?ri[Lt[1]]-ri[Lt[0]]:Ce,rt=w.ticks,je=w.border,Yt=rt.show?rt.size:0,an=yn(Yt*Dt),Cn=yn((w.alignTo==2?w._size-Yt-w.gap:w.gap)*Dt),Gt=w._rotate*-Ml/180,ln=g(w._pos*Dt),oi=(an+Cn)*ve,Xn=ln+oi;Q=F==0?Xn:0,X=F==1?Xn:0;let bi=w.font[0],Ii=w.align==1?Qr:w.align==2?Mh:Gt>0?Qr:Gt<0?Mh:F==0?"center":L==3?Mh:Qr,Ki=Gt||F==1?"middle":L==2?"top":Rp;Fe(bi,fe,Ii,Ki);let ai=w.font[1]*w.lineGap,Mi=Lt.map(qn=>g(a(qn,ze,Xe,pt))),Li=w._values;for(let qn=0;qn<Li.length;qn++){let li=Li[qn];if(li!=null){F==0?X=Mi[qn]:Q=Mi[qn],li=""+li;let ur=li.indexOf(`
`)==-1?[li]:li.split(/\n/gm);for(let Yn=0;Yn<ur.length;Yn++){let Xf=ur[Yn];Gt?(d.save(),d.translate(X,Q+Yn*ai),d.rotate(Gt),d.fillText(Xf,0,0),d.restore()):d.fillText(Xf,X,Q+Yn*ai)}}}rt.show&&fn(Mi,rt.filter(n,Rt,_,ke,Mt),F,L,ln,an,Wt(rt.width*Dt,3),rt.stroke(n,_),rt.dash,rt.cap);let ji=w.grid;ji.show&&fn(Mi,ji.filter(n,Rt,_,ke,Mt),F,F==0?2:1,F==0?S:R,F==0?he:Y,Wt(ji.width*Dt,3),ji.stroke(n,_),ji.dash,ji.cap),je.show&&fn([ln],[1],F==0?1:0,F==0?1:2,F==1?S:R,F==1?he:Y,Wt(je.width*Dt,3),je.stroke(n,_),je.dash,je.cap)}Rn("drawAxes")}function gt(_){y.forEach((w,L)=>{L>0&&(w._paths=null,_&&(s==1?(w.min=null,w.max=null):w.facets.forEach(F=>{F.min=null,F.max=null})))})}let on=!1,Wn=!1,Bt=[];function pn(){Wn=!1;for(let _=0;_<Bt.length;_++)Rn(...Bt[_]);Bt.length=0}function kn(){on||(D_(Af),on=!0)}function ol(_,w=!1){on=!0,Wn=w,_(n),Af(),w&&Bt.length>0&&queueMicrotask(pn)}n.batch=ol;function Af(){if(ce&&(yt(),ce=!1),Me&&(Re(),Me=!1),Te){if($t(f,Qr,et),$t(f,"top",ht),$t(f,ha,B),$t(f,da,De),$t(p,Qr,et),$t(p,"top",ht),$t(p,ha,B),$t(p,da,De),$t(h,ha,Pt),$t(h,da,kt),u.width=yn(Pt*Dt),u.height=yn(kt*Dt),A.forEach(({_el:_,_show:w,_size:L,_pos:F,side:X})=>{if(_!=null)if(w){let Q=X===3||X===0?L:0,fe=X%2==1;$t(_,fe?"left":"top",F-Q),$t(_,fe?"width":"height",L),$t(_,fe?"top":"left",fe?ht:et),$t(_,fe?"height":"width",fe?De:B),Ih(_,Mr)}else di(_,Mr)}),Or=Ps=Br=W=ne=Z=j=Ie=T=null,Ue=1,Yo(!0),et!=we||ht!=It||B!=Ye||De!=Ke){gt(!1);let _=B/Ye,w=De/Ke;if(xe&&!se&&de.left>=0){de.left*=_,de.top*=w,zr&&Qi(zr,yn(de.left),0,B,De),Gr&&Qi(Gr,0,yn(de.top),B,De);for(let L=0;L<ie.length;L++){let F=ie[L];F!=null&&(ge[L]*=_,Be[L]*=w,Qi(F,Ti(ge[L]),Ti(Be[L]),B,De))}}if(qt.show&&!oe&&qt.left>=0&&qt.width>0){qt.left*=_,qt.width*=_,qt.top*=w,qt.height*=w;for(let L in Gu)$t(Wr,L,qt[L])}we=et,It=ht,Ye=B,Ke=De}Rn("setSize"),Te=!1}Pt>0&&kt>0&&(d.clearRect(0,0,u.width,u.height),Rn("drawClear"),M.forEach(_=>_()),Rn("draw")),qt.show&&oe&&(al(qt),oe=!1),xe&&se&&(cr(null,!0,!1),se=!1),ue.show&&ue.live&&_e&&(ku(),_e=!1),c||(c=!0,n.status=1,Rn("ready")),Cs=!1,on=!1}n.redraw=(_,w)=>{Me=w||!1,_!==!1?Ls(E,D.min,D.max):kn()};function Fu(_,w){let L=b[_];if(L.from==null){if(rn==0){let F=L.range(n,w.min,w.max,_);w.min=F[0],w.max=F[1]}if(w.min>w.max){let F=w.min;w.min=w.max,w.max=F}if(rn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;_==E&&L.distr==2&&rn>0&&(w.min=Ui(w.min,e[0]),w.max=Ui(w.max,e[0]),w.min==w.max&&w.max++),V[_]=w,ce=!0,kn()}}n.setScale=Fu;let Ou,Bu,zr,Gr,Rf,Cf,Vr,Hr,Pf,If,Xt,Kt,Is=!1,Fn=de.drag,En=Fn.x,An=Fn.y;xe&&(de.x&&(Ou=wi(i_,p)),de.y&&(Bu=wi(s_,p)),D.ori==0?(zr=Ou,Gr=Bu):(zr=Bu,Gr=Ou),Xt=de.left,Kt=de.top);let qt=n.select=gn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Wr=qt.show?wi(n_,qt.over?p:f):null;function al(_,w){if(qt.show){for(let L in _)qt[L]=_[L],L in Gu&&$t(Wr,L,_[L]);w!==!1&&Rn("setSelect")}}n.setSelect=al;function hx(_){if(y[_].show)K&&Ih(Qe[_],Mr);else if(K&&di(Qe[_],Mr),xe){let L=O?ie[0]:ie[_];L!=null&&Qi(L,-10,-10,B,De)}}function Ls(_,w,L){Fu(_,{min:w,max:L})}function Zi(_,w,L,F){w.focus!=null&&gx(_),w.show!=null&&y.forEach((X,Q)=>{Q>0&&(_==Q||_==null)&&(X.show=w.show,hx(Q),s==2?(Ls(X.facets[0].scale,null,null),Ls(X.facets[1].scale,null,null)):Ls(X.scale,null,null),kn())}),L!==!1&&Rn("setSeries",_,w),F&&$o("setSeries",n,_,w)}n.setSeries=Zi;function dx(_,w){gn(C[_],w)}function fx(_,w){_.fill=Tt(_.fill||null),_.dir=Ct(_.dir,-1),w=w??C.length,C.splice(w,0,_)}function px(_){_==null?C.length=0:C.splice(_,1)}n.addBand=fx,n.setBand=dx,n.delBand=px;function mx(_,w){y[_].alpha=w,xe&&ie[_]!=null&&(ie[_].style.opacity=w),K&&Qe[_]&&(Qe[_].style.opacity=w)}let hs,Ds,lr,Xr={focus:!0};function gx(_){if(_!=lr){let w=_==null,L=He.alpha!=1;y.forEach((F,X)=>{if(s==1||X>0){let Q=w||X==0||X==_;F._focus=w?null:Q,L&&mx(X,Q?1:He.alpha)}}),lr=_,L&&kn()}}K&&st&&ut(Lp,Pe,_=>{de._lock||(it(_),lr!=null&&Zi(null,Xr,!0,mn.setSeries))});function Ji(_,w,L){let F=b[w];L&&(_=_/Dt-(F.ori==1?ht:et));let X=B;F.ori==1&&(X=De,_=X-_),F.dir==-1&&(_=X-_);let Q=F._min,fe=F._max,ve=_/X,Ce=Q+(fe-Q)*ve,ke=F.distr;return ke==3?no(10,Ce):ke==4?b_(Ce,F.asinh):ke==100?F.bwd(Ce):Ce}function xx(_,w){let L=Ji(_,E,w);return Ui(L,e[0],un,hn)}n.valToIdx=_=>Ui(_,e[0]),n.posToIdx=xx,n.posToVal=Ji,n.valToPos=(_,w,L)=>b[w].ori==0?r(_,b[w],L?Y:B,L?R:0):o(_,b[w],L?he:De,L?S:0),n.setCursor=(_,w,L)=>{Xt=_.left,Kt=_.top,cr(null,w,L)};function Lf(_,w){$t(Wr,Qr,qt.left=_),$t(Wr,ha,qt.width=w)}function Df(_,w){$t(Wr,"top",qt.top=_),$t(Wr,da,qt.height=w)}let Xo=D.ori==0?Lf:Df,qo=D.ori==1?Lf:Df;function _x(){if(K&&ue.live)for(let _=s==2?1:0;_<y.length;_++){if(_==0&&ft)continue;let w=ue.values[_],L=0;for(let F in w)Ge[_][L++].firstChild.nodeValue=w[F]}}function ku(_,w){if(_!=null&&(_.idxs?_.idxs.forEach((L,F)=>{te[F]=L}):T_(_.idx)||te.fill(_.idx),ue.idx=te[0]),K&&ue.live){for(let L=0;L<y.length;L++)(L>0||s==1&&!ft)&&vx(L,te[L]);_x()}_e=!1,w!==!1&&Rn("setLegend")}n.setLegend=ku;function vx(_,w){let L=y[_],F=_==0&&G==2?ri:e[_],X;ft?X=L.values(n,_,w)??tt:(X=L.value(n,w==null?null:F[w],_,w),X=X==null?tt:{_:X}),ue.values[_]=X}function cr(_,w,L){Pf=Xt,If=Kt,[Xt,Kt]=de.move(n,Xt,Kt),de.left=Xt,de.top=Kt,xe&&(zr&&Qi(zr,yn(Xt),0,B,De),Gr&&Qi(Gr,0,yn(Kt),B,De));let F,X=un>hn;hs=Ht,Ds=null;let Q=D.ori==0?B:De,fe=D.ori==1?B:De;if(Xt<0||rn==0||X){F=de.idx=null;for(let ve=0;ve<y.length;ve++){let Ce=ie[ve];Ce!=null&&Qi(Ce,-10,-10,B,De)}st&&Zi(null,Xr,!0,_==null&&mn.setSeries),ue.live&&(te.fill(F),_e=!0)}else{let ve,Ce,ke;s==1&&(ve=D.ori==0?Xt:Kt,Ce=Ji(ve,E),F=de.idx=Ui(Ce,e[0],un,hn),ke=H(e[0][F],D,Q,0));let ze=-10,Xe=-10,pt=0,Lt=0,Rt=!0,Mt="",rt="";for(let je=s==2?1:0;je<y.length;je++){let Yt=y[je],an=te[je],Cn=an==null?null:s==1?e[je][an]:e[je][1][an],Gt=de.dataIdx(n,je,F,Ce),ln=Gt==null?null:s==1?e[je][Gt]:e[je][1][Gt];if(_e=_e||ln!=Cn||Gt!=an,te[je]=Gt,je>0&&Yt.show){let oi=Gt==null?-10:Gt==F?ke:H(s==1?e[0][Gt]:e[je][0][Gt],D,Q,0),Xn=ln==null?-10:P(ln,s==1?b[Yt.scale]:b[Yt.facets[1].scale],fe,0);if(st&&ln!=null){let bi=D.ori==1?Xt:Kt,Ii=bn(He.dist(n,je,Gt,Xn,bi));if(Ii<hs){let Ki=He.bias;if(Ki!=0){let ai=Ji(bi,Yt.scale),Mi=ln>=0?1:-1,Li=ai>=0?1:-1;Li==Mi&&(Li==1?Ki==1?ln>=ai:ln<=ai:Ki==1?ln<=ai:ln>=ai)&&(hs=Ii,Ds=je)}else hs=Ii,Ds=je}}if(_e||O){let bi,Ii;D.ori==0?(bi=oi,Ii=Xn):(bi=Xn,Ii=oi);let Ki,ai,Mi,Li,ji,qn,li=!0,ur=pe.bbox;if(ur!=null){li=!1;let Yn=ur(n,je);Mi=Yn.left,Li=Yn.top,Ki=Yn.width,ai=Yn.height}else Mi=bi,Li=Ii,Ki=ai=pe.size(n,je);if(qn=pe.fill(n,je),ji=pe.stroke(n,je),O)je==Ds&&hs<=He.prox&&(ze=Mi,Xe=Li,pt=Ki,Lt=ai,Rt=li,Mt=qn,rt=ji);else{let Yn=ie[je];Yn!=null&&(ge[je]=Mi,Be[je]=Li,kp(Yn,Ki,ai,li),Op(Yn,qn,ji),Qi(Yn,Ti(Mi),Ti(Li),B,De))}}}}if(O){let je=He.prox,Yt=lr==null?hs<=je:hs>je||Ds!=lr;if(_e||Yt){let an=ie[0];an!=null&&(ge[0]=ze,Be[0]=Xe,kp(an,pt,Lt,Rt),Op(an,Mt,rt),Qi(an,Ti(ze),Ti(Xe),B,De))}}}if(qt.show&&Is)if(_!=null){let[ve,Ce]=mn.scales,[ke,ze]=mn.match,[Xe,pt]=_.cursor.sync.scales,Lt=_.cursor.drag;if(En=Lt._x,An=Lt._y,En||An){let{left:Rt,top:Mt,width:rt,height:je}=_.select,Yt=_.scales[Xe].ori,an=_.posToVal,Cn,Gt,ln,oi,Xn,bi=ve!=null&&ke(ve,Xe),Ii=Ce!=null&&ze(Ce,pt);bi&&En?(Yt==0?(Cn=Rt,Gt=rt):(Cn=Mt,Gt=je),ln=b[ve],oi=H(an(Cn,Xe),ln,Q,0),Xn=H(an(Cn+Gt,Xe),ln,Q,0),Xo(Fi(oi,Xn),bn(Xn-oi))):Xo(0,Q),Ii&&An?(Yt==1?(Cn=Rt,Gt=rt):(Cn=Mt,Gt=je),ln=b[Ce],oi=P(an(Cn,pt),ln,fe,0),Xn=P(an(Cn+Gt,pt),ln,fe,0),qo(Fi(oi,Xn),bn(Xn-oi))):qo(0,fe)}else Vu()}else{let ve=bn(Pf-Rf),Ce=bn(If-Cf);if(D.ori==1){let pt=ve;ve=Ce,Ce=pt}En=Fn.x&&ve>=Fn.dist,An=Fn.y&&Ce>=Fn.dist;let ke=Fn.uni;ke!=null?En&&An&&(En=ve>=ke,An=Ce>=ke,!En&&!An&&(Ce>ve?An=!0:En=!0)):Fn.x&&Fn.y&&(En||An)&&(En=An=!0);let ze,Xe;En&&(D.ori==0?(ze=Vr,Xe=Xt):(ze=Hr,Xe=Kt),Xo(Fi(ze,Xe),bn(Xe-ze)),An||qo(0,fe)),An&&(D.ori==1?(ze=Vr,Xe=Xt):(ze=Hr,Xe=Kt),qo(Fi(ze,Xe),bn(Xe-ze)),En||Xo(0,Q)),!En&&!An&&(Xo(0,0),qo(0,0))}if(Fn._x=En,Fn._y=An,_==null){if(L){if(Wf!=null){let[ve,Ce]=mn.scales;mn.values[0]=ve!=null?Ji(D.ori==0?Xt:Kt,ve):null,mn.values[1]=Ce!=null?Ji(D.ori==1?Xt:Kt,Ce):null}$o(Sh,n,Xt,Kt,B,De,F)}if(st){let ve=L&&mn.setSeries,Ce=He.prox;lr==null?hs<=Ce&&Zi(Ds,Xr,!0,ve):hs>Ce?Zi(null,Xr,!0,ve):Ds!=lr&&Zi(Ds,Xr,!0,ve)}}_e&&(ue.idx=F,ku()),w!==!1&&Rn("setCursor")}let Ns=null;Object.defineProperty(n,"rect",{get(){return Ns==null&&Yo(!1),Ns}});function Yo(_=!1){_?Ns=null:(Ns=p.getBoundingClientRect(),Rn("syncRect",Ns))}function Nf(_,w,L,F,X,Q,fe){de._lock||Is&&_!=null&&_.movementX==0&&_.movementY==0||(zu(_,w,L,F,X,Q,fe,!1,_!=null),_!=null?cr(null,!0,!0):cr(w,!0,!1))}function zu(_,w,L,F,X,Q,fe,ve,Ce){if(Ns==null&&Yo(!1),it(_),_!=null)L=_.clientX-Ns.left,F=_.clientY-Ns.top;else{if(L<0||F<0){Xt=-10,Kt=-10;return}let[ke,ze]=mn.scales,Xe=w.cursor.sync,[pt,Lt]=Xe.values,[Rt,Mt]=Xe.scales,[rt,je]=mn.match,Yt=w.axes[0].side%2==1,an=D.ori==0?B:De,Cn=D.ori==1?B:De,Gt=Yt?Q:X,ln=Yt?X:Q,oi=Yt?F:L,Xn=Yt?L:F;if(Rt!=null?L=rt(ke,Rt)?a(pt,b[ke],an,0):-10:L=an*(oi/Gt),Mt!=null?F=je(ze,Mt)?a(Lt,b[ze],Cn,0):-10:F=Cn*(Xn/ln),D.ori==1){let bi=L;L=F,F=bi}}Ce&&(w==null||w.cursor.event.type==Sh)&&((L<=1||L>=B-1)&&(L=yr(L,B)),(F<=1||F>=De-1)&&(F=yr(F,De))),ve?(Rf=L,Cf=F,[Vr,Hr]=de.move(n,L,F)):(Xt=L,Kt=F)}let Gu={width:0,height:0,left:0,top:0};function Vu(){al(Gu,!1)}let Uf,Ff,Of,Bf;function kf(_,w,L,F,X,Q,fe){Is=!0,En=An=Fn._x=Fn._y=!1,zu(_,w,L,F,X,Q,fe,!0,!1),_!=null&&(ut(wh,Ch,zf,!1),$o(Pp,n,Vr,Hr,B,De,null));let{left:ve,top:Ce,width:ke,height:ze}=qt;Uf=ve,Ff=Ce,Of=ke,Bf=ze}function zf(_,w,L,F,X,Q,fe){Is=Fn._x=Fn._y=!1,zu(_,w,L,F,X,Q,fe,!1,!0);let{left:ve,top:Ce,width:ke,height:ze}=qt,Xe=ke>0||ze>0,pt=Uf!=ve||Ff!=Ce||Of!=ke||Bf!=ze;if(Xe&&pt&&al(qt),Fn.setScale&&Xe&&pt){let Lt=ve,Rt=ke,Mt=Ce,rt=ze;if(D.ori==1&&(Lt=Ce,Rt=ze,Mt=ve,rt=ke),En&&Ls(E,Ji(Lt,E),Ji(Lt+Rt,E)),An)for(let je in b){let Yt=b[je];je!=E&&Yt.from==null&&Yt.min!=Ht&&Ls(je,Ji(Mt+rt,je),Ji(Mt,je))}Vu()}else de.lock&&(de._lock=!de._lock,cr(w,!0,_!=null));_!=null&&(Jt(wh,Ch),$o(wh,n,Xt,Kt,B,De,null))}function yx(_,w,L,F,X,Q,fe){if(de._lock)return;it(_);let ve=Is;if(Is){let Ce=!0,ke=!0,ze=10,Xe,pt;D.ori==0?(Xe=En,pt=An):(Xe=An,pt=En),Xe&&pt&&(Ce=Xt<=ze||Xt>=B-ze,ke=Kt<=ze||Kt>=De-ze),Xe&&Ce&&(Xt=Xt<Vr?0:B),pt&&ke&&(Kt=Kt<Hr?0:De),cr(null,!0,!0),Is=!1}Xt=-10,Kt=-10,te.fill(null),cr(null,!0,!0),ve&&(Is=ve)}function Gf(_,w,L,F,X,Q,fe){de._lock||(it(_),Wo(),Vu(),_!=null&&$o(Dp,n,Xt,Kt,B,De,null))}function Vf(){A.forEach(Gv),k(n.width,n.height,!0)}Sr(Sl,to,Vf);let qr={};qr.mousedown=kf,qr.mousemove=Nf,qr.mouseup=zf,qr.dblclick=Gf,qr.setSeries=(_,w,L,F)=>{let X=mn.match[2];L=X(n,w,L),L!=-1&&Zi(L,F,!0,!1)},xe&&(ut(Pp,p,kf),ut(Sh,p,Nf),ut(Ip,p,_=>{it(_),Yo(!1)}),ut(Lp,p,yx),ut(Dp,p,Gf),Oh.add(n),n.syncRect=Yo);let ll=n.hooks=i.hooks||{};function Rn(_,w,L){Wn?Bt.push([_,w,L]):_ in ll&&ll[_].forEach(F=>{F.call(null,n,w,L)})}(i.plugins||[]).forEach(_=>{for(let w in _.hooks)ll[w]=(ll[w]||[]).concat(_.hooks[w])});let Hf=(_,w,L)=>L,mn=gn({key:null,setSeries:!1,filters:{pub:Wp,sub:Wp},scales:[E,y[1]?y[1].scale:null],match:[Xp,Xp,Hf],values:[null,null]},de.sync);mn.match.length==2&&mn.match.push(Hf),de.sync=mn;let Wf=mn.key,Hu=Gm(Wf);function $o(_,w,L,F,X,Q,fe){mn.filters.pub(_,w,L,F,X,Q,fe)&&Hu.pub(_,w,L,F,X,Q,fe)}Hu.sub(n);function bx(_,w,L,F,X,Q,fe){mn.filters.sub(_,w,L,F,X,Q,fe)&&qr[_](null,w,L,F,X,Q,fe)}n.pub=bx;function Mx(){Hu.unsub(n),Oh.delete(n),nt.clear(),Lh(Sl,to,Vf),l.remove(),Pe?.remove(),Rn("destroy")}n.destroy=Mx;function Wu(){Rn("init",i,e),Ho(e||i.data,!1),V[E]?Fu(E,V[E]):Wo(),oe=qt.show&&(qt.width>0||qt.height>0),se=_e=!0,k(i.width,i.height)}return y.forEach(mt),A.forEach(Un),t?t instanceof HTMLElement?(t.appendChild(l),Wu()):t(n,Wu):Wu(),n}In.assign=gn;In.fmtNum=Wh;In.rangeNum=wl;In.rangeLog=Al;In.rangeAsinh=Vh;In.orient=Tr;In.pxRatio=Dt;In.join=L_;In.fmtDate=qh,In.tzDate=H_;In.sync=Gm;{In.addGap=Tv,In.clipGaps=Pl;let i=In.paths={points:Ym};i.linear=Zm,i.stepped=Rv,i.bars=Cv,i.spline=Iv}var Nl="#D55E00",Vv="11px system-ui, sans-serif",Qm=7,Hv=3.6,Qh=new Map,Xs=class{constructor(e){this.options=e;let{title:t,unit:n,lines:s,duration:r,sync:o,onTime:a}=e,c=`${t} (${n})`;this.values=s.map(({colour:h,label:f,mark:p,dashed:v})=>{let g=p===void 0?J("i",{class:v?"line dashed":"line",style:`--colour:${h||"var(--ink)"}`}):ei(p,h);return J("span",{title:f,class:"value"},g,J("b"))});let l={tabindex:0,role:"slider","aria-label":c,"aria-valuemin":0,"aria-valuemax":r,"aria-valuenow":0,"aria-valuetext":""};this.place=J("div",{class:"plot",...a?l:{role:"img","aria-label":c}}),this.element=J("figure",{},J("figcaption",{},J("span",{},c),J("span",{class:"readout"},...this.values)),this.place);let u={stroke:()=>ci("soft"),font:Vv,grid:{stroke:()=>ci("grid"),width:1},ticks:{stroke:()=>ci("grid"),width:1,size:4}},d=In.paths.stepped({align:1});this.plot=new In({width:320,height:150,legend:{show:!1},padding:[8,18,0,0],cursor:{points:{show:!1},y:!1,drag:{x:o!==void 0,y:!1},...o&&{sync:{key:o,scales:["x",null]}}},scales:{x:{time:!1,range:(h,f,p)=>Number.isFinite(f)&&f<p?[f,p]:[0,r]},y:{range:(h,f,p)=>this.visible(f??0,p??0,e.range??e.limits)}},axes:[{...u,size:26,gap:3,values:(h,f)=>f.map(p=>p===f.at(-1)?`${p} s`:`${p}`)},{...u,size:46,gap:3,values:(h,f)=>f.map(p=>`${Number(p.toPrecision(6))}`.replace("-","\u2212"))}],series:[{},...s.map(({label:h,colour:f,dashed:p,held:v,mark:g})=>({label:h,stroke:()=>f||ci("ink"),width:p?1.25:1.6,points:{show:!1},...p?{dash:[5,4]}:g!==void 0&&{dash:$f(g)},...v&&{paths:d}}))],hooks:{drawClear:[h=>e.limits&&Wv(h,e.limits)],draw:[h=>s.forEach((f,p)=>f.mark!==void 0&&Xv(h,p+1,f))],setScale:[(h,f)=>f==="x"&&this.zoomGroup(h)],setSize:[()=>this.seek(this.time)]}},[[0,r],...s.map(()=>[null,null])],this.place),this.plot.over.append(this.playhead),a&&(this.plot.over.addEventListener("click",h=>{let{left:f}=this.plot.over.getBoundingClientRect();a(this.plot.posToVal(h.clientX-f,"x"))}),this.place.addEventListener("keydown",h=>this.key(h,a))),o&&Qh.set(o,[...Qh.get(o)??[],this]),new ResizeObserver(()=>this.plot.setSize({width:this.place.clientWidth,height:this.place.clientHeight})).observe(this.place),Us(()=>this.plot.redraw(!1))}options;element;place;values;playhead=J("div",{class:"playhead"});plot;time=0;get canvas(){return this.plot.ctx.canvas}show(e,t){let[{min:n,max:s}]=[this.plot.scales.x];this.plot.setData([e,...t],!1),this.plot.setScale("x",{min:n??0,max:s??this.options.duration})}setDuration(e){this.options.duration=e,this.place.setAttribute("aria-valuemax",`${e}`),this.plot.setScale("x",{min:0,max:e})}setLimits(e){this.options.limits=e}setRange(e){this.options.range=e}setVisible(e,t){this.plot.setSeries(e+1,{show:t}),this.values[e].hidden=!t}seek(e){this.time=e;let{left:t,width:n}=this.plot.bbox,s=this.plot.valToPos(e,"x");this.playhead.style.transform=`translateX(${s}px)`,this.playhead.hidden=!(s>=0&&s<=n/devicePixelRatio+1)||t===0;let[r,...o]=this.plot.data,a=0;r.length>1&&(a=Math.min(Math.max(Math.round((e-r[0])/(r[1]-r[0])),0),r.length-1)),o.forEach((c,l)=>{let u=c[a],d=u==null?"\u2013":Pn(u,this.options.digits??1),h=this.values[l].lastElementChild;h.textContent!==d&&(h.textContent=d)}),document.activeElement===this.place&&this.describe()}describe(){let e=this.values.flatMap(t=>t.hidden?[]:[`${t.title} ${t.textContent}`]);this.place.setAttribute("aria-valuenow",this.time.toFixed(2)),this.place.setAttribute("aria-valuetext",`at ${this.time.toFixed(2)} s: ${e.join(", ")} ${this.options.unit}`)}key(e,t){let n=e.shiftKey?1:.1,{min:s,max:r}=this.plot.scales.x,o=l=>{let u=.5*l*((r??1)-(s??0)),d=Math.min(Math.max(this.time,u),Math.max(this.options.duration-u,u));this.plot.setScale("x",{min:Math.max(d-u,0),max:Math.min(d+u,this.options.duration)})},c={ArrowLeft:()=>t(Math.max(this.time-n,0)),ArrowRight:()=>t(Math.min(this.time+n,this.options.duration)),Home:()=>t(0),End:()=>t(this.options.duration),...this.options.sync&&{"+":()=>o(.5),"=":()=>o(.5),"-":()=>o(2),0:()=>o(1e3)}}[e.key];!c||e.ctrlKey||e.metaKey||e.altKey||(c(),this.describe(),e.preventDefault())}visible(e,t,n){let s=Math.min(e,n?.[0]??e),r=Math.max(t,n?.[1]??t),o=Math.max(.07*(r-s),1e-6);return[s-o,r+o]}zoomGroup(e){let{min:t,max:n}=e.scales.x;if(!(t==null||n==null)){for(let s of Qh.get(this.options.sync??"")??[]){let r=s.plot?.scales.x;s!==this&&r&&(r.min!==t||r.max!==n)&&s.plot.setScale("x",{min:t,max:n})}this.seek(this.time)}}};function Wv(i,e){let{ctx:t,bbox:n}=i,[s,r]=e.map(o=>Math.min(Math.max(i.valToPos(o,"y",!0),n.top),n.top+n.height));t.save(),t.fillStyle=`${Nl}17`,t.fillRect(n.left,n.top,n.width,r-n.top),t.fillRect(n.left,s,n.width,n.top+n.height-s),t.strokeStyle=`${Nl}99`,t.lineWidth=devicePixelRatio,t.beginPath();for(let o of[s,r])t.moveTo(n.left,Math.round(o)+.5),t.lineTo(n.left+n.width,Math.round(o)+.5);t.stroke(),t.restore()}function Xv(i,e,{mark:t=0,colour:n}){if(!i.series[e].show)return;let{ctx:s,bbox:r}=i,{min:o,max:a}=i.scales.x,[c,l]=[i.data[0],i.data[e]];if(o==null||a==null||c.length<2)return;let u=Hv*devicePixelRatio,d=new Path2D(Zo(t));s.save(),s.beginPath(),s.rect(r.left,r.top,r.width,r.height),s.clip(),s.fillStyle=n||ci("ink");for(let h=0;h<Qm;h++){let f=o+(h+.2+.13*t)/Qm*(a-o),p=l[Math.round((f-c[0])/(c[1]-c[0]))];p!=null&&(s.save(),s.translate(i.valToPos(f,"x",!0),i.valToPos(p,"y",!0)),s.scale(u,u),s.fill(d),s.restore())}s.restore()}var xa=400,qs={left:44,right:10,top:10,bottom:38},qv=75,Er=class{element;paths;tails;dots;place;points=[];constructor({title:e,axes:t,corners:n=[],outer:s=[],curve:r=[],ticks:o,colours:a,marks:c=!0}){let l=[...n,...s,...r],u=[0,1].map(m=>[Math.min(...l.map(y=>y[m])),Math.max(...l.map(y=>y[m]))]),d=u.map(([m,y])=>.08*(y-m)),h={width:xa-qs.left-qs.right,height:xa-qs.top-qs.bottom};this.place=([m,y])=>[qs.left+h.width*(m-u[0][0]+d[0])/(u[0][1]-u[0][0]+2*d[0]),qs.top+h.height-h.height*(y-u[1][0]+d[1])/(u[1][1]-u[1][0]+2*d[1])];let f=jt("svg",{viewBox:`0 0 ${xa} ${xa}`,role:"img","aria-label":`${e}: ${t.join(", ")}`}),p={x:qs.left,y:qs.top,...h};f.append(jt("rect",{...p,class:"frame"}));for(let m of o[0]){let[y]=this.place([m,0]);f.append(jt("line",{x1:y,x2:y,y1:p.y,y2:p.y+p.height,class:"grid"}),jt("text",{x:y,y:p.y+p.height+14,class:"tick"},`${m}`.replace("-","\u2212")))}for(let m of o[1]){let[,y]=this.place([0,m]);f.append(jt("line",{x1:p.x,x2:p.x+p.width,y1:y,y2:y,class:"grid"}),jt("text",{x:p.x-5,y:y+4,class:"tick end"},`${m}`.replace("-","\u2212")))}f.append(jt("text",{x:p.x+p.width/2,y:xa-6,class:"label"},t[0]),jt("text",{x:0,y:0,class:"label",transform:`translate(12 ${p.y+p.height/2}) rotate(-90)`},t[1]));let v=m=>cl(m.map(this.place));s.length&&f.append(jt("polygon",{points:v(s),class:"outer"})),n.length&&f.append(jt("polygon",{points:v(n),class:"set",stroke:Nl})),r.length&&f.append(jt("polyline",{points:v(r),class:"curve"}));let g=m=>a.map(y=>jt("polyline",{class:m,stroke:y,points:""}));[this.paths,this.tails]=[g("path"),g("path tail")],this.dots=a.map((m,y)=>jt("path",{d:Zo(c?y:0),fill:m,class:"dot"})),f.append(...this.paths,...this.tails,...this.dots),this.element=J("figure",{class:"set"},J("figcaption",{},J("span",{},e)),f)}show(e){this.points=e.map(t=>t.map(this.place)),this.paths.forEach((t,n)=>t.setAttribute("points",cl(this.points[n])))}setVisible(e,t){for(let n of[this.paths[e],this.tails[e],this.dots[e]])n.toggleAttribute("hidden",!t)}seek(e){this.dots.forEach((t,n)=>{let s=this.points[n]??[];if(s.length===0)return;let r=Math.min(e,s.length-1),[o,a]=s[r];this.tails[n].setAttribute("points",cl(s.slice(Math.max(0,r-qv),r+1))),t.setAttribute("transform",`translate(${o.toFixed(1)} ${a.toFixed(1)}) scale(5)`)})}};var ed=["travel","travel rate","elevation","elevation rate","pitch","pitch rate"],eg=["#0072B2","#56B4E9","#009E73","#E69F00","#CC79A7","#7A5195"],tg=([i,e])=>[[i,i],[e,i],[e,e],[i,e]];function co(i,e){let t=(e-i)/4,n=10**Math.floor(Math.log10(t)),s=n*([1,2,5,10].find(o=>o*n>=t)??10),r=Math.ceil(i/s);return Array.from({length:Math.floor(e/s)-r+1},(o,a)=>Number(((r+a)*s).toPrecision(6)))}var Ul=class{constructor(e,t,n,s){this.policies=e;this.period=t;this.lines=n;this.onTime=s}policies;period;lines;onTime;element=J("section",{class:"paper"});figures=[];experiment=null;flights=[];turn=0;rebuild(e,t){this.experiment=e,this.figures=[];let n=this.policies.map(({colour:z})=>z),{rig:s}=e,r=ca(e.setup),o=s.parameters,a=this.period*e.steps,c=(z,N,re,...q)=>J("div",{class:"figure"},J("h3",{},z),Ep(N),J("p",{class:"small"},re),...q),l=(z,N)=>{let re=new Er(z);return this.figures.push({refresh:()=>re.show(this.flights.map(q=>q?N(q):[])),seek:q=>re.seek(Math.floor(q/this.period)),show:(q,$)=>re.setVisible(q,$)}),re.element},u=(z,N,re,q,$=1,te)=>{let ue=new Xs({title:z,unit:N,lines:re,duration:a,digits:$,onTime:this.onTime,...te&&{range:te}}),de=e.reference.x.map((K,xe)=>xe*this.period);return this.figures.push({refresh:()=>ue.show(de,q()),seek:K=>ue.seek(K),show:(K,xe)=>re===this.lines&&ue.setVisible(K,xe)}),ue.element},d=z=>()=>this.flights.map(N=>e.reference.x.map((re,q)=>N&&q<N.x.length?z(N,q):null)),h=(z,N)=>z.u[Math.min(N,z.u.length-1)]??z.rotors,[f,p]=s.amplifier,v=co(f,p),g=Array.from({length:61},(z,N)=>[f+(p-f)*N/60,ni([f+(p-f)*N/60,0],o)[0]]),[m,y]=Zr(r.u,o),A=([z,N])=>[[0,2*z],[N-z,z+N],[0,2*N],[z-N,z+N]],b=Zr(s.amplifier,o),C=co(2*b[0],2*b[1]),E=r.pitch[1],x=Array.from({length:61},(z,N)=>{let re=(N/30-1)*1.6*E;return[Vt(re),Vt(E*Math.tanh(re/E))]}),M=z=>E*Math.atanh(Math.min(Math.max(z/E,-.999),.999)),U=co(-1.5*Vt(E),1.5*Vt(E)),{front:I}=o,D="cubics"in I?"f_i = interpolated points":`f_i = k_\xB1 ${I.dead_zone?"( | u_i | \u2212 u_0 )":"| u_i |"}^${I.exponent} sgn u_i`,G=this.policies.findIndex(({name:z},N)=>t[N]&&(z==="feedforward+tvlqr"||z==="yours")),H=e.gains(G<0?"feedforward+tvlqr":this.policies[G].name),P=ed.map((z,N)=>({label:z,colour:eg[N],mark:N})),V=z=>()=>ed.map((N,re)=>e.reference.x.map((q,$)=>H[Math.min($,H.length-1)][z][re]));this.element.replaceChildren(J("h2",{},"The paper, drawn from this flight"),J("div",{class:"figures"},c("(2) thrust",D,"Thrust of the front fan over its voltage, and where each flight is on it.",l({title:"thrust of the front fan",axes:["front voltage (V)","thrust (N)"],curve:g,ticks:[v,co(g[0][1],g[60][1])],colours:n},z=>z.u.map(N=>[N[0],ni(N,o)[0]]))),c("(3a) travel","q\u0308_1 = b_1 cos q_2 sin q_3 v_1 \u2212 c_1 q\u0307_1","Only a pitched helicopter accelerates sideways: the travel acceleration that (3) makes of pitch and thrust.",u("travel acceleration","deg/s\xB2",this.lines,d((z,N)=>Vt(On(z.x[N],ii(h(z,N),o),o)[1])),1,[-1,1])),c("(6), (9) voltages","u_min \u2264 u_f , u_b \u2264 u_max","The window of the plan, in the range of the amplifier.",l({title:"voltages",axes:["front voltage (V)","back voltage (V)"],corners:tg(r.u),outer:tg(s.amplifier),ticks:[v,v],colours:n},z=>z.u)),c("(4), (17)\u2013(20) virtual inputs","v_1 = f_f + f_b , v_2 = f_f \u2212 f_b","The window becomes a rhombus: much thrust leaves little for the difference.",l({title:"virtual inputs",axes:["thrust difference v2 (N)","thrust sum v1 (N)"],corners:A([m,y]),outer:A(b),ticks:[co(b[0]-b[1],b[1]-b[0]),C],colours:n},z=>z.u.map(N=>ii(N,o).reverse()))),c("(25)\u2013(29) pitch limit","q_3 = \u03C8_1 ( \u03BE_1 )","The paper's smooth saturation: whatever \u03BE does, the pitch of the plan stays within its limits.",l({title:"saturation of the pitch",axes:["\u03BE (deg)","pitch (deg)"],curve:x,ticks:[U,co(-Vt(E),Vt(E))],colours:n},z=>z.x.map(N=>{let re=Math.min(Math.max(N[4],-.98*E),.98*E);return[Vt(M(re)),Vt(re)]}))),c("(51) feedback","v = v_d \u2212 K ( t ) ( x \u2212 x_d )","Fig. 10: a start that is off, and how the feedback removes the error of the elevation.",u("elevation error","deg, positive down",this.lines,d((z,N)=>Vt(z.x[N][2]-e.reference.x[N][2])),2,[-.1,.1])),...H?[c("(50), (51) gains","K ( t ) = R^\u22121 B^T P ( t )","Gains on the thrust sum, in N/rad and N s/rad; the marker names the state.",u("gains on v1","N/rad, N s/rad",P,V(0))),c("(50), (51) gains","\u2212 \u1E56 = P A + A^T P \u2212 P B R^\u22121 B^T P + Q","Gains on the thrust difference.",u("gains on v2","N/rad, N s/rad",P,V(1)),J("p",{class:"legend small"},...ed.map((z,N)=>J("span",{},ei(N,eg[N]),z))))]:[])),this.policies.forEach((z,N)=>this.setVisible(N,t[N]))}setVisible(e,t){for(let{show:n}of this.figures)n?.(e,t)}refresh(e,t,n){if(!this.experiment)return;this.flights=e;let s=n?this.figures:[this.figures[this.turn++%this.figures.length]];for(let r of s)r.refresh(),r.seek(t)}};var Tg=0,Pd=1,Eg=2;var Xa=1,Ag=2,Uo=3,or=0,Qn=1,Ci=2,Ir=0,Fo=1,Id=2,Ld=3,Dd=4,Rg=5;var Lr=100,Cg=101,Pg=102,Ig=103,Lg=104,Dg=200,Ng=201,Ug=202,Fg=203,Nd=204,Ud=205,Og=206,Bg=207,kg=208,zg=209,Gg=210,Vg=211,Hg=212,Wg=213,Xg=214,sc=0,rc=1,oc=2,To=3,ac=4,lc=5,cc=6,uc=7,Fc=0,qg=1,Yg=2,os=0,Fd=1,Od=2,Bd=3,kd=4,zd=5,Gd=6,Vd=7;var Hd=300,Dr=301,Oo=302,Oc=303,Bc=304,hc=1e3,ts=1001,dc=1002,Dn=1003,$g=1004;var qa=1005;var Kn=1006,kc=1007;var ws=1008;var si=1009,Wd=1010,Xd=1011,Bo=1012,zc=1013,Gi=1014,Vi=1015,Hi=1016,Gc=1017,Vc=1018,Nr=1020,qd=35902,Yd=35899,$d=1021,Zd=1022,Wi=1023,bs=1026,Ts=1027,Jd=1028,Hc=1029,ar=1030,Wc=1031;var Xc=1033,Ya=33776,$a=33777,Za=33778,Ja=33779,qc=35840,Yc=35841,$c=35842,Zc=35843,Jc=36196,Kc=37492,jc=37496,Qc=37488,eu=37489,Ka=37490,tu=37491,nu=37808,iu=37809,su=37810,ru=37811,ou=37812,au=37813,lu=37814,cu=37815,uu=37816,hu=37817,du=37818,fu=37819,pu=37820,mu=37821,gu=36492,xu=36494,_u=36495,vu=36283,yu=36284,ja=36285,bu=36286;var Sa=2300,fc=2301,nc=2302,Sd=2303,wd=2400,Td=2401,Ed=2402;var Zg=3200;var Mu=0,Jg=1,Es="",Zn="srgb",wa="srgb-linear",Ta="linear",Ut="srgb";var ic=7680;var Kg=519,jg=512,Qg=513,e0=514,Kd=515,t0=516,n0=517,jd=518,Qd=519,i0=35044;var ef="300 es",Ai=2e3,Eo=2001;function Yv(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function $v(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ea(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function s0(){let i=Ea("canvas");return i.style.display="block",i}var ng={},Ao=null;function tf(...i){let e="THREE."+i.shift();Ao?Ao("log",e,...i):console.log(e,...i)}function r0(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function ot(...i){i=r0(i);let e="THREE."+i.shift();if(Ao)Ao("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function lt(...i){i=r0(i);let e="THREE."+i.shift();if(Ao)Ao("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ma(...i){let e=i.join(" ");e in ng||(ng[e]=!0,ot(...i))}function o0(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var a0={[sc]:sc,[oc]:cc,[ac]:ac,[To]:lc,[rc]:rc,[cc]:oc,[uc]:uc,[lc]:To},ns=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},zn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var td=Math.PI/180,pc=180/Math.PI;function Qa(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(zn[i&255]+zn[i>>8&255]+zn[i>>16&255]+zn[i>>24&255]+"-"+zn[e&255]+zn[e>>8&255]+"-"+zn[e>>16&15|64]+zn[e>>24&255]+"-"+zn[t&63|128]+zn[t>>8&255]+"-"+zn[t>>16&255]+zn[t>>24&255]+zn[n&255]+zn[n>>8&255]+zn[n>>16&255]+zn[n>>24&255]).toLowerCase()}function At(i,e,t){return Math.max(e,Math.min(t,i))}function Zv(i,e){return(i%e+e)%e}function nd(i,e,t){return(1-t)*i+t*e}function l0(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function nf(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Jv(i,e){if(e.constructor===Float32Array)return i;let t=nf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Kv(i,e){if(e.constructor===Float32Array)return i;let t=nf(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var St=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=At(this.x,e.x,t.x),this.y=At(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=At(this.x,e,t),this.y=At(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(At(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(At(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},is=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let c=n[s+0],l=n[s+1],u=n[s+2],d=n[s+3],h=r[o+0],f=r[o+1],p=r[o+2],v=r[o+3];if(d!==v||c!==h||l!==f||u!==p){let g=c*h+l*f+u*p+d*v;g<0&&(h=-h,f=-f,p=-p,v=-v,g=-g);let m=1-a;if(g<.9995){let y=Math.acos(g),A=Math.sin(y);m=Math.sin(m*y)/A,a=Math.sin(a*y)/A,c=c*m+h*a,l=l*m+f*a,u=u*m+p*a,d=d*m+v*a}else{c=c*m+h*a,l=l*m+f*a,u=u*m+p*a,d=d*m+v*a;let y=1/Math.sqrt(c*c+l*l+u*u+d*d);c*=y,l*=y,u*=y,d*=y}}e[t]=c,e[t+1]=l,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],u=n[s+3],d=r[o],h=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*d+c*f-l*h,e[t+1]=c*p+u*h+l*d-a*f,e[t+2]=l*p+u*f+a*h-c*d,e[t+3]=u*p-a*d-c*h-l*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(n/2),u=a(s/2),d=a(r/2),h=c(n/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=h*u*d+l*f*p,this._y=l*f*d-h*u*p,this._z=l*u*p+h*f*d,this._w=l*u*d-h*f*p;break;case"YXZ":this._x=h*u*d+l*f*p,this._y=l*f*d-h*u*p,this._z=l*u*p-h*f*d,this._w=l*u*d+h*f*p;break;case"ZXY":this._x=h*u*d-l*f*p,this._y=l*f*d+h*u*p,this._z=l*u*p+h*f*d,this._w=l*u*d-h*f*p;break;case"ZYX":this._x=h*u*d-l*f*p,this._y=l*f*d+h*u*p,this._z=l*u*p-h*f*d,this._w=l*u*d+h*f*p;break;case"YZX":this._x=h*u*d+l*f*p,this._y=l*f*d+h*u*p,this._z=l*u*p-h*f*d,this._w=l*u*d-h*f*p;break;case"XZY":this._x=h*u*d-l*f*p,this._y=l*f*d-h*u*p,this._z=l*u*p+h*f*d,this._w=l*u*d+h*f*p;break;default:ot("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],c=t[9],l=t[2],u=t[6],d=t[10],h=n+a+d;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(u-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(u-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+u)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(At(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,c=t._y,l=t._z,u=t._w;return this._x=n*u+o*a+s*l-r*c,this._y=s*u+o*c+r*a-n*l,this._z=r*u+o*l+n*c-s*a,this._w=o*u-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let c=1-t;if(a<.9995){let l=Math.acos(a),u=Math.sin(l);c=Math.sin(c*l)/u,t=Math.sin(t*l)/u,this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},ee=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(ig.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(ig.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*s-a*n),u=2*(a*t-r*s),d=2*(r*n-o*t);return this.x=t+c*l+o*d-a*u,this.y=n+c*u+a*l-r*d,this.z=s+c*d+r*u-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=At(this.x,e.x,t.x),this.y=At(this.y,e.y,t.y),this.z=At(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=At(this.x,e,t),this.y=At(this.y,e,t),this.z=At(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(At(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,c=t.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return id.copy(this).projectOnVector(e),this.sub(id)}reflect(e){return this.sub(id.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(At(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},id=new ee,ig=new is,dt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l)}set(e,t,n,s,r,o,a,c,l){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=c,u[6]=n,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],u=n[4],d=n[7],h=n[2],f=n[5],p=n[8],v=s[0],g=s[3],m=s[6],y=s[1],A=s[4],b=s[7],C=s[2],E=s[5],x=s[8];return r[0]=o*v+a*y+c*C,r[3]=o*g+a*A+c*E,r[6]=o*m+a*b+c*x,r[1]=l*v+u*y+d*C,r[4]=l*g+u*A+d*E,r[7]=l*m+u*b+d*x,r[2]=h*v+f*y+p*C,r[5]=h*g+f*A+p*E,r[8]=h*m+f*b+p*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8];return t*o*u-t*a*l-n*r*u+n*a*c+s*r*l-s*o*c}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8],d=u*o-a*l,h=a*c-u*r,f=l*r-o*c,p=t*d+n*h+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=d*v,e[1]=(s*l-u*n)*v,e[2]=(a*n-s*o)*v,e[3]=h*v,e[4]=(u*t-s*c)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(n*c-l*t)*v,e[8]=(o*t-n*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+e,-s*l,s*c,-s*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return Ma("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(sd.makeScale(e,t)),this}rotate(e){return Ma("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(sd.makeRotation(-e)),this}translate(e,t){return Ma("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(sd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},sd=new dt,sg=new dt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),rg=new dt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function jv(){let i={enabled:!0,workingColorSpace:wa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ut&&(s.r=ys(s.r),s.g=ys(s.g),s.b=ys(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ut&&(s.r=wo(s.r),s.g=wo(s.g),s.b=wo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Es?Ta:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[wa]:{primaries:e,whitePoint:n,transfer:Ta,toXYZ:sg,fromXYZ:rg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Zn},outputColorSpaceConfig:{drawingBufferColorSpace:Zn}},[Zn]:{primaries:e,whitePoint:n,transfer:Ut,toXYZ:sg,fromXYZ:rg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Zn}}}),i}var Et=jv();function ys(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function wo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var uo,mc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{uo===void 0&&(uo=Ea("canvas")),uo.width=e.width,uo.height=e.height;let s=uo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=uo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ea("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ys(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(ys(t[n]/255)*255):t[n]=ys(t[n]);return{data:t,width:e.width,height:e.height}}else return ot("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Qv=0,Ro=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Qv++}),this.uuid=Qa(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(rd(s[o].image)):r.push(rd(s[o]))}else r=rd(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function rd(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?mc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(ot("Texture: Unable to serialize Texture."),{})}var ey=0,od=new ee,jn=class i extends ns{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ts,s=ts,r=Kn,o=ws,a=Wi,c=si,l=i.DEFAULT_ANISOTROPY,u=Es){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ey++}),this.uuid=Qa(),this.name="",this.source=new Ro(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new St(0,0),this.repeat=new St(1,1),this.center=new St(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new dt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(od).x}get height(){return this.source.getSize(od).y}get depth(){return this.source.getSize(od).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){ot(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){ot(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Hd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case hc:e.x=e.x-Math.floor(e.x);break;case ts:e.x=e.x<0?0:1;break;case dc:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case hc:e.y=e.y-Math.floor(e.y);break;case ts:e.y=e.y<0?0:1;break;case dc:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};jn.DEFAULT_IMAGE=null;jn.DEFAULT_MAPPING=Hd;jn.DEFAULT_ANISOTROPY=1;var tn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,c=e.elements,l=c[0],u=c[4],d=c[8],h=c[1],f=c[5],p=c[9],v=c[2],g=c[6],m=c[10];if(Math.abs(u-h)<.01&&Math.abs(d-v)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+v)<.1&&Math.abs(p+g)<.1&&Math.abs(l+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(l+1)/2,b=(f+1)/2,C=(m+1)/2,E=(u+h)/4,x=(d+v)/4,M=(p+g)/4;return A>b&&A>C?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=x/n):b>C?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=E/s,r=M/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=x/r,s=M/r),this.set(n,s,r,t),this}let y=Math.sqrt((g-p)*(g-p)+(d-v)*(d-v)+(h-u)*(h-u));return Math.abs(y)<.001&&(y=1),this.x=(g-p)/y,this.y=(d-v)/y,this.z=(h-u)/y,this.w=Math.acos((l+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=At(this.x,e.x,t.x),this.y=At(this.y,e.y,t.y),this.z=At(this.z,e.z,t.z),this.w=At(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=At(this.x,e,t),this.y=At(this.y,e,t),this.z=At(this.z,e,t),this.w=At(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(At(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},gc=class extends ns{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Kn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new tn(0,0,e,t),this.scissorTest=!1,this.viewport=new tn(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new jn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Kn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Ro(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},_i=class extends gc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Aa=class extends jn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Dn,this.minFilter=Dn,this.wrapR=ts,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var xc=class extends jn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=Dn,this.minFilter=Dn,this.wrapR=ts,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Qt=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,c,l,u,d,h,f,p,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l,u,d,h,f,p,v,g)}set(e,t,n,s,r,o,a,c,l,u,d,h,f,p,v,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=c,m[2]=l,m[6]=u,m[10]=d,m[14]=h,m[3]=f,m[7]=p,m[11]=v,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/ho.setFromMatrixColumn(e,0).length(),r=1/ho.setFromMatrixColumn(e,1).length(),o=1/ho.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let h=o*u,f=o*d,p=a*u,v=a*d;t[0]=c*u,t[4]=-c*d,t[8]=l,t[1]=f+p*l,t[5]=h-v*l,t[9]=-a*c,t[2]=v-h*l,t[6]=p+f*l,t[10]=o*c}else if(e.order==="YXZ"){let h=c*u,f=c*d,p=l*u,v=l*d;t[0]=h+v*a,t[4]=p*a-f,t[8]=o*l,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=v+h*a,t[10]=o*c}else if(e.order==="ZXY"){let h=c*u,f=c*d,p=l*u,v=l*d;t[0]=h-v*a,t[4]=-o*d,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=v-h*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let h=o*u,f=o*d,p=a*u,v=a*d;t[0]=c*u,t[4]=p*l-f,t[8]=h*l+v,t[1]=c*d,t[5]=v*l+h,t[9]=f*l-p,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let h=o*c,f=o*l,p=a*c,v=a*l;t[0]=c*u,t[4]=v-h*d,t[8]=p*d+f,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-l*u,t[6]=f*d+p,t[10]=h-v*d}else if(e.order==="XZY"){let h=o*c,f=o*l,p=a*c,v=a*l;t[0]=c*u,t[4]=-d,t[8]=l*u,t[1]=h*d+v,t[5]=o*u,t[9]=f*d-p,t[2]=p*d-f,t[6]=a*u,t[10]=v*d+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(ty,e,ny)}lookAt(e,t,n){let s=this.elements;return mi.subVectors(e,t),mi.lengthSq()===0&&(mi.z=1),mi.normalize(),Ys.crossVectors(n,mi),Ys.lengthSq()===0&&(Math.abs(n.z)===1?mi.x+=1e-4:mi.z+=1e-4,mi.normalize(),Ys.crossVectors(n,mi)),Ys.normalize(),Fl.crossVectors(mi,Ys),s[0]=Ys.x,s[4]=Fl.x,s[8]=mi.x,s[1]=Ys.y,s[5]=Fl.y,s[9]=mi.y,s[2]=Ys.z,s[6]=Fl.z,s[10]=mi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],u=n[1],d=n[5],h=n[9],f=n[13],p=n[2],v=n[6],g=n[10],m=n[14],y=n[3],A=n[7],b=n[11],C=n[15],E=s[0],x=s[4],M=s[8],U=s[12],I=s[1],D=s[5],G=s[9],H=s[13],P=s[2],V=s[6],z=s[10],N=s[14],re=s[3],q=s[7],$=s[11],te=s[15];return r[0]=o*E+a*I+c*P+l*re,r[4]=o*x+a*D+c*V+l*q,r[8]=o*M+a*G+c*z+l*$,r[12]=o*U+a*H+c*N+l*te,r[1]=u*E+d*I+h*P+f*re,r[5]=u*x+d*D+h*V+f*q,r[9]=u*M+d*G+h*z+f*$,r[13]=u*U+d*H+h*N+f*te,r[2]=p*E+v*I+g*P+m*re,r[6]=p*x+v*D+g*V+m*q,r[10]=p*M+v*G+g*z+m*$,r[14]=p*U+v*H+g*N+m*te,r[3]=y*E+A*I+b*P+C*re,r[7]=y*x+A*D+b*V+C*q,r[11]=y*M+A*G+b*z+C*$,r[15]=y*U+A*H+b*N+C*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],c=e[9],l=e[13],u=e[2],d=e[6],h=e[10],f=e[14],p=e[3],v=e[7],g=e[11],m=e[15],y=c*f-l*h,A=a*f-l*d,b=a*h-c*d,C=o*f-l*u,E=o*h-c*u,x=o*d-a*u;return t*(v*y-g*A+m*b)-n*(p*y-g*C+m*E)+s*(p*A-v*C+m*x)-r*(p*b-v*E+g*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],c=e[2],l=e[6],u=e[10];return t*(o*u-a*l)-n*(r*u-a*c)+s*(r*l-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8],d=e[9],h=e[10],f=e[11],p=e[12],v=e[13],g=e[14],m=e[15],y=t*a-n*o,A=t*c-s*o,b=t*l-r*o,C=n*c-s*a,E=n*l-r*a,x=s*l-r*c,M=u*v-d*p,U=u*g-h*p,I=u*m-f*p,D=d*g-h*v,G=d*m-f*v,H=h*m-f*g,P=y*H-A*G+b*D+C*I-E*U+x*M;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/P;return e[0]=(a*H-c*G+l*D)*V,e[1]=(s*G-n*H-r*D)*V,e[2]=(v*x-g*E+m*C)*V,e[3]=(h*E-d*x-f*C)*V,e[4]=(c*I-o*H-l*U)*V,e[5]=(t*H-s*I+r*U)*V,e[6]=(g*b-p*x-m*A)*V,e[7]=(u*x-h*b+f*A)*V,e[8]=(o*G-a*I+l*M)*V,e[9]=(n*I-t*G-r*M)*V,e[10]=(p*E-v*b+m*y)*V,e[11]=(d*b-u*E-f*y)*V,e[12]=(a*U-o*D-c*M)*V,e[13]=(t*D-n*U+s*M)*V,e[14]=(v*A-p*C-g*y)*V,e[15]=(u*C-d*A+h*y)*V,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,c=e.z,l=r*o,u=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,u*a+n,u*c-s*o,0,l*c-s*a,u*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,c=t._w,l=r+r,u=o+o,d=a+a,h=r*l,f=r*u,p=r*d,v=o*u,g=o*d,m=a*d,y=c*l,A=c*u,b=c*d,C=n.x,E=n.y,x=n.z;return s[0]=(1-(v+m))*C,s[1]=(f+b)*C,s[2]=(p-A)*C,s[3]=0,s[4]=(f-b)*E,s[5]=(1-(h+m))*E,s[6]=(g+y)*E,s[7]=0,s[8]=(p+A)*x,s[9]=(g-y)*x,s[10]=(1-(h+v))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=ho.set(s[0],s[1],s[2]).length(),a=ho.set(s[4],s[5],s[6]).length(),c=ho.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Oi.copy(this);let l=1/o,u=1/a,d=1/c;return Oi.elements[0]*=l,Oi.elements[1]*=l,Oi.elements[2]*=l,Oi.elements[4]*=u,Oi.elements[5]*=u,Oi.elements[6]*=u,Oi.elements[8]*=d,Oi.elements[9]*=d,Oi.elements[10]*=d,t.setFromRotationMatrix(Oi),n.x=o,n.y=a,n.z=c,this}makePerspective(e,t,n,s,r,o,a=Ai,c=!1){let l=this.elements,u=2*r/(t-e),d=2*r/(n-s),h=(t+e)/(t-e),f=(n+s)/(n-s),p,v;if(c)p=r/(o-r),v=o*r/(o-r);else if(a===Ai)p=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Eo)p=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=d,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=v,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ai,c=!1){let l=this.elements,u=2/(t-e),d=2/(n-s),h=-(t+e)/(t-e),f=-(n+s)/(n-s),p,v;if(c)p=1/(o-r),v=o/(o-r);else if(a===Ai)p=-2/(o-r),v=-(o+r)/(o-r);else if(a===Eo)p=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=h,l[1]=0,l[5]=d,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=v,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},ho=new ee,Oi=new Qt,ty=new ee(0,0,0),ny=new ee(1,1,1),Ys=new ee,Fl=new ee,mi=new ee,og=new Qt,ag=new is,Ms=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],u=s[9],d=s[2],h=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(At(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,l),this._z=0);break;case"YXZ":this._x=Math.asin(-At(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(At(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-At(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(At(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-At(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ot("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return og.makeRotationFromQuaternion(e),this.setFromRotationMatrix(og,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return ag.setFromEuler(this),this.setFromQuaternion(ag,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Ms.DEFAULT_ORDER="XYZ";var Ra=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},iy=0,lg=new ee,fo=new is,ms=new Qt,Ol=new ee,_a=new ee,sy=new ee,ry=new is,cg=new ee(1,0,0),ug=new ee(0,1,0),hg=new ee(0,0,1),dg={type:"added"},oy={type:"removed"},po={type:"childadded",child:null},ad={type:"childremoved",child:null},Vn=class i extends ns{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:iy++}),this.uuid=Qa(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new ee,t=new Ms,n=new is,s=new ee(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Qt},normalMatrix:{value:new dt}}),this.matrix=new Qt,this.matrixWorld=new Qt,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ra,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return fo.setFromAxisAngle(e,t),this.quaternion.multiply(fo),this}rotateOnWorldAxis(e,t){return fo.setFromAxisAngle(e,t),this.quaternion.premultiply(fo),this}rotateX(e){return this.rotateOnAxis(cg,e)}rotateY(e){return this.rotateOnAxis(ug,e)}rotateZ(e){return this.rotateOnAxis(hg,e)}translateOnAxis(e,t){return lg.copy(e).applyQuaternion(this.quaternion),this.position.add(lg.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(cg,e)}translateY(e){return this.translateOnAxis(ug,e)}translateZ(e){return this.translateOnAxis(hg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ms.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Ol.copy(e):Ol.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),_a.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ms.lookAt(_a,Ol,this.up):ms.lookAt(Ol,_a,this.up),this.quaternion.setFromRotationMatrix(ms),s&&(ms.extractRotation(s.matrixWorld),fo.setFromRotationMatrix(ms),this.quaternion.premultiply(fo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(lt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(dg),po.child=e,this.dispatchEvent(po),po.child=null):lt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(oy),ad.child=e,this.dispatchEvent(ad),ad.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ms.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ms.multiply(e.parent.matrixWorld)),e.applyMatrix4(ms),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(dg),po.child=e,this.dispatchEvent(po),po.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(_a,e,sy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(_a,ry,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let d=c[l];r(e.shapes,d)}else r(e.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(e.materials,this.material[c]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),l=o(e.textures),u=o(e.images),d=o(e.shapes),h=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),u.length>0&&(n.images=u),d.length>0&&(n.shapes=d),h.length>0&&(n.skeletons=h),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Vn.DEFAULT_UP=new ee(0,1,0);Vn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Vn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var xi=class extends Vn{constructor(){super(),this.isGroup=!0,this.type="Group"}},ay={type:"move"},Co=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new xi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new xi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new ee,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new ee),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new xi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new ee,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new ee,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,n),m=this._getHandJoint(l,v);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=l.joints["index-finger-tip"],d=l.joints["thumb-tip"],h=u.position.distanceTo(d.position),f=.02,p=.005;l.inputState.pinching&&h>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&h<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ay)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new xi;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},c0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},$s={h:0,s:0,l:0},Bl={h:0,s:0,l:0};function ld(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var vt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Zn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Et.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Et.workingColorSpace){return this.r=e,this.g=t,this.b=n,Et.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Et.workingColorSpace){if(e=Zv(e,1),t=At(t,0,1),n=At(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=ld(o,r,e+1/3),this.g=ld(o,r,e),this.b=ld(o,r,e-1/3)}return Et.colorSpaceToWorking(this,s),this}setStyle(e,t=Zn){function n(r){r!==void 0&&parseFloat(r)<1&&ot("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:ot("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);ot("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Zn){let n=c0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):ot("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ys(e.r),this.g=ys(e.g),this.b=ys(e.b),this}copyLinearToSRGB(e){return this.r=wo(e.r),this.g=wo(e.g),this.b=wo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Zn){return Et.workingToColorSpace(Gn.copy(this),e),Math.round(At(Gn.r*255,0,255))*65536+Math.round(At(Gn.g*255,0,255))*256+Math.round(At(Gn.b*255,0,255))}getHexString(e=Zn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Et.workingColorSpace){Et.workingToColorSpace(Gn.copy(this),t);let n=Gn.r,s=Gn.g,r=Gn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let d=o-a;switch(l=u<=.5?d/(o+a):d/(2-o-a),o){case n:c=(s-r)/d+(s<r?6:0);break;case s:c=(r-n)/d+2;break;case r:c=(n-s)/d+4;break}c/=6}return e.h=c,e.s=l,e.l=u,e}getRGB(e,t=Et.workingColorSpace){return Et.workingToColorSpace(Gn.copy(this),t),e.r=Gn.r,e.g=Gn.g,e.b=Gn.b,e}getStyle(e=Zn){Et.workingToColorSpace(Gn.copy(this),e);let t=Gn.r,n=Gn.g,s=Gn.b;return e!==Zn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL($s),this.setHSL($s.h+e,$s.s+t,$s.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL($s),e.getHSL(Bl);let n=nd($s.h,Bl.h,t),s=nd($s.s,Bl.s,t),r=nd($s.l,Bl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Gn=new vt;vt.NAMES=c0;var Ca=class extends Vn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Ms,this.environmentIntensity=1,this.environmentRotation=new Ms,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Bi=new ee,gs=new ee,cd=new ee,xs=new ee,mo=new ee,go=new ee,fg=new ee,ud=new ee,hd=new ee,dd=new ee,fd=new tn,pd=new tn,md=new tn,js=class i{constructor(e=new ee,t=new ee,n=new ee){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Bi.subVectors(e,t),s.cross(Bi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Bi.subVectors(s,t),gs.subVectors(n,t),cd.subVectors(e,t);let o=Bi.dot(Bi),a=Bi.dot(gs),c=Bi.dot(cd),l=gs.dot(gs),u=gs.dot(cd),d=o*l-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,f=(l*c-a*u)*h,p=(o*u-a*c)*h;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,xs)===null?!1:xs.x>=0&&xs.y>=0&&xs.x+xs.y<=1}static getInterpolation(e,t,n,s,r,o,a,c){return this.getBarycoord(e,t,n,s,xs)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,xs.x),c.addScaledVector(o,xs.y),c.addScaledVector(a,xs.z),c)}static getInterpolatedAttribute(e,t,n,s,r,o){return fd.setScalar(0),pd.setScalar(0),md.setScalar(0),fd.fromBufferAttribute(e,t),pd.fromBufferAttribute(e,n),md.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(fd,r.x),o.addScaledVector(pd,r.y),o.addScaledVector(md,r.z),o}static isFrontFacing(e,t,n,s){return Bi.subVectors(n,t),gs.subVectors(e,t),Bi.cross(gs).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Bi.subVectors(this.c,this.b),gs.subVectors(this.a,this.b),Bi.cross(gs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;mo.subVectors(s,n),go.subVectors(r,n),ud.subVectors(e,n);let c=mo.dot(ud),l=go.dot(ud);if(c<=0&&l<=0)return t.copy(n);hd.subVectors(e,s);let u=mo.dot(hd),d=go.dot(hd);if(u>=0&&d<=u)return t.copy(s);let h=c*d-u*l;if(h<=0&&c>=0&&u<=0&&c-u>0)return o=c/(c-u),t.copy(n).addScaledVector(mo,o);dd.subVectors(e,r);let f=mo.dot(dd),p=go.dot(dd);if(p>=0&&f<=p)return t.copy(r);let v=f*l-c*p;if(v<=0&&l>=0&&p<=0)return a=l/(l-p),t.copy(n).addScaledVector(go,a);let g=u*p-f*d;if(g<=0&&d-u>=0&&f-p>=0)return fg.subVectors(r,s),a=(d-u)/(d-u+(f-p)),t.copy(s).addScaledVector(fg,a);let m=1/(g+v+h);return o=v*m,a=h*m,t.copy(n).addScaledVector(mo,o).addScaledVector(go,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Qs=class{constructor(e=new ee(1/0,1/0,1/0),t=new ee(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(ki.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(ki.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=ki.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ki):ki.fromBufferAttribute(r,o),ki.applyMatrix4(e.matrixWorld),this.expandByPoint(ki);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),kl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),kl.copy(n.boundingBox)),kl.applyMatrix4(e.matrixWorld),this.union(kl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ki),ki.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(va),zl.subVectors(this.max,va),xo.subVectors(e.a,va),_o.subVectors(e.b,va),vo.subVectors(e.c,va),Zs.subVectors(_o,xo),Js.subVectors(vo,_o),Ar.subVectors(xo,vo);let t=[0,-Zs.z,Zs.y,0,-Js.z,Js.y,0,-Ar.z,Ar.y,Zs.z,0,-Zs.x,Js.z,0,-Js.x,Ar.z,0,-Ar.x,-Zs.y,Zs.x,0,-Js.y,Js.x,0,-Ar.y,Ar.x,0];return!gd(t,xo,_o,vo,zl)||(t=[1,0,0,0,1,0,0,0,1],!gd(t,xo,_o,vo,zl))?!1:(Gl.crossVectors(Zs,Js),t=[Gl.x,Gl.y,Gl.z],gd(t,xo,_o,vo,zl))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ki).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ki).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(_s[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),_s[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),_s[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),_s[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),_s[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),_s[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),_s[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),_s[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(_s),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},_s=[new ee,new ee,new ee,new ee,new ee,new ee,new ee,new ee],ki=new ee,kl=new Qs,xo=new ee,_o=new ee,vo=new ee,Zs=new ee,Js=new ee,Ar=new ee,va=new ee,zl=new ee,Gl=new ee,Rr=new ee;function gd(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Rr.fromArray(i,r);let a=s.x*Math.abs(Rr.x)+s.y*Math.abs(Rr.y)+s.z*Math.abs(Rr.z),c=e.dot(Rr),l=t.dot(Rr),u=n.dot(Rr);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var xn=new ee,Vl=new St,ly=0,Ri=class extends ns{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:ly++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=i0,this.updateRanges=[],this.gpuType=Vi,this.version=0,this._normalizationScale=e!==void 0?nf(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Vl.fromBufferAttribute(this,t),Vl.applyMatrix3(e),this.setXY(t,Vl.x,Vl.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix3(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Jv(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Kv(e,this.array)}};var Pa=class extends Ri{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Ia=class extends Ri{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var en=class extends Ri{constructor(e,t,n){super(new Float32Array(e),t,n)}},cy=new Qs,ya=new ee,xd=new ee,Po=class{constructor(e=new ee,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):cy.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ya.subVectors(e,this.center);let t=ya.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(ya,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(xd.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ya.copy(e.center).add(xd)),this.expandByPoint(ya.copy(e.center).sub(xd))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},uy=0,Ei=new Qt,_d=new Vn,yo=new ee,gi=new Qs,ba=new Qs,Ln=new ee,vi=class i extends ns{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:uy++}),this.uuid=Qa(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Yv(e)?Ia:Pa)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new dt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ei.makeRotationFromQuaternion(e),this.applyMatrix4(Ei),this}rotateX(e){return Ei.makeRotationX(e),this.applyMatrix4(Ei),this}rotateY(e){return Ei.makeRotationY(e),this.applyMatrix4(Ei),this}rotateZ(e){return Ei.makeRotationZ(e),this.applyMatrix4(Ei),this}translate(e,t,n){return Ei.makeTranslation(e,t,n),this.applyMatrix4(Ei),this}scale(e,t,n){return Ei.makeScale(e,t,n),this.applyMatrix4(Ei),this}lookAt(e){return _d.lookAt(e),_d.updateMatrix(),this.applyMatrix4(_d.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(yo).negate(),this.translate(yo.x,yo.y,yo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new en(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&ot("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){lt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new ee(-1/0,-1/0,-1/0),new ee(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];gi.setFromBufferAttribute(r),this.morphTargetsRelative?(Ln.addVectors(this.boundingBox.min,gi.min),this.boundingBox.expandByPoint(Ln),Ln.addVectors(this.boundingBox.max,gi.max),this.boundingBox.expandByPoint(Ln)):(this.boundingBox.expandByPoint(gi.min),this.boundingBox.expandByPoint(gi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&lt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Po);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){lt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new ee,1/0);return}if(e){let n=this.boundingSphere.center;if(gi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];ba.setFromBufferAttribute(a),this.morphTargetsRelative?(Ln.addVectors(gi.min,ba.min),gi.expandByPoint(Ln),Ln.addVectors(gi.max,ba.max),gi.expandByPoint(Ln)):(gi.expandByPoint(ba.min),gi.expandByPoint(ba.max))}gi.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Ln.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Ln));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)Ln.fromBufferAttribute(a,l),c&&(yo.fromBufferAttribute(e,l),Ln.add(yo)),s=Math.max(s,n.distanceToSquared(Ln))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&lt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){lt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Ri(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let U=0;U<n.count;U++)a[U]=new ee,c[U]=new ee;let u=new ee,d=new ee,h=new ee,f=new St,p=new St,v=new St,g=new ee,m=new ee;function y(U,I,D){l[U]=l[I]=l[D]=1,u.fromBufferAttribute(n,U),d.fromBufferAttribute(n,I),h.fromBufferAttribute(n,D),f.fromBufferAttribute(r,U),p.fromBufferAttribute(r,I),v.fromBufferAttribute(r,D),d.sub(u),h.sub(u),p.sub(f),v.sub(f);let G=1/(p.x*v.y-v.x*p.y);isFinite(G)&&(g.copy(d).multiplyScalar(v.y).addScaledVector(h,-p.y).multiplyScalar(G),m.copy(h).multiplyScalar(p.x).addScaledVector(d,-v.x).multiplyScalar(G),a[U].add(g),a[I].add(g),a[D].add(g),c[U].add(m),c[I].add(m),c[D].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let U=0,I=A.length;U<I;++U){let D=A[U],G=D.start,H=D.count;for(let P=G,V=G+H;P<V;P+=3)y(e.getX(P+0),e.getX(P+1),e.getX(P+2))}let b=new ee,C=new ee,E=new ee,x=new ee;function M(U){E.fromBufferAttribute(s,U),x.copy(E);let I=a[U];b.copy(I),b.sub(E.multiplyScalar(E.dot(I))).normalize(),C.crossVectors(x,I);let G=C.dot(c[U])<0?-1:1;o.setXYZW(U,b.x,b.y,b.z,G)}for(let U=0,I=n.count;U<I;++U)l[U]&&M(U);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Ri(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let h=0,f=n.count;h<f;h++)n.setXYZ(h,0,0,0);let s=new ee,r=new ee,o=new ee,a=new ee,c=new ee,l=new ee,u=new ee,d=new ee;if(e)for(let h=0,f=e.count;h<f;h+=3){let p=e.getX(h+0),v=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(n,p),c.fromBufferAttribute(n,v),l.fromBufferAttribute(n,g),a.add(u),c.add(u),l.add(u),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(v,c.x,c.y,c.z),n.setXYZ(g,l.x,l.y,l.z)}else for(let h=0,f=t.count;h<f;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),n.setXYZ(h+0,u.x,u.y,u.z),n.setXYZ(h+1,u.x,u.y,u.z),n.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Ln.fromBufferAttribute(e,t),Ln.normalize(),e.setXYZ(t,Ln.x,Ln.y,Ln.z)}toNonIndexed(){function e(a,c){let l=a.array,u=a.itemSize,d=a.normalized,h=new l.constructor(c.length*u),f=0,p=0;for(let v=0,g=c.length;v<g;v++){a.isInterleavedBufferAttribute?f=c[v]*a.data.stride+a.offset:f=c[v]*u;for(let m=0;m<u;m++)h[p++]=l[f++]}return new Ri(h,u,d)}if(this.index===null)return ot("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=e(c,n);t.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let u=0,d=l.length;u<d;u++){let h=l[u],f=e(h,n);c.push(f)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let c in n){let l=n[c];e.data.attributes[c]=l.toJSON(e.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let d=0,h=l.length;d<h;d++){let f=l[d];u.push(f.toJSON(e.data))}u.length>0&&(s[c]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let l in s){let u=s[l];this.setAttribute(l,u.clone(t))}let r=e.morphAttributes;for(let l in r){let u=[],d=r[l];for(let h=0,f=d.length;h<f;h++)u.push(d[h].clone(t));this.morphAttributes[l]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,u=o.length;l<u;l++){let d=o[l];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var vd=new ee,hy=new ee,dy=new dt,zi=class{constructor(e=new ee(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=vd.subVectors(n,t).cross(hy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(vd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||dy.getNormalMatrix(e),s=this.coplanarPoint(vd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},fy=0,er=class extends ns{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:fy++}),this.uuid=Qa(),this.name="",this.type="Material",this.blending=Fo,this.side=or,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Nd,this.blendDst=Ud,this.blendEquation=Lr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new vt(0,0,0),this.blendAlpha=0,this.depthFunc=To,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Kg,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ic,this.stencilZFail=ic,this.stencilZPass=ic,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){ot(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){ot(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new vt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new zi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new St().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new St().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var vs=new ee,yd=new ee,Hl=new ee,Wl=new ee,_c=class{constructor(e=new ee,t=new ee(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,vs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=vs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(vs.copy(this.origin).addScaledVector(this.direction,t),vs.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){yd.copy(e).add(t).multiplyScalar(.5),Hl.copy(t).sub(e).normalize(),Wl.copy(this.origin).sub(yd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Hl),a=Wl.dot(this.direction),c=-Wl.dot(Hl),l=Wl.lengthSq(),u=Math.abs(1-o*o),d,h,f,p;if(u>0)if(d=o*c-a,h=o*a-c,p=r*u,d>=0)if(h>=-p)if(h<=p){let v=1/u;d*=v,h*=v,f=d*(d+o*h+2*a)+h*(o*d+h+2*c)+l}else h=r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*c)+l;else h=-r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*c)+l;else h<=-p?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-c),r),f=-d*d+h*(h+2*c)+l):h<=p?(d=0,h=Math.min(Math.max(-r,-c),r),f=h*(h+2*c)+l):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-c),r),f=-d*d+h*(h+2*c)+l);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(yd).addScaledVector(Hl,h),f}intersectSphere(e,t){if(e.radius<0)return null;vs.subVectors(e.center,this.origin);let n=vs.dot(this.direction),s=vs.dot(vs)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,c,l=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return l>=0?(n=(e.min.x-h.x)*l,s=(e.max.x-h.x)*l):(n=(e.max.x-h.x)*l,s=(e.min.x-h.x)*l),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-h.z)*d,c=(e.max.z-h.z)*d):(a=(e.max.z-h.z)*d,c=(e.min.z-h.z)*d),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,vs)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,u=a.z,d=e.x-o.x,h=e.y-o.y,f=e.z-o.z,p=t.x-o.x,v=t.y-o.y,g=t.z-o.z,m=n.x-o.x,y=n.y-o.y,A=n.z-o.z,b=Math.abs(c),C=Math.abs(l),E=Math.abs(u),x,M,U,I,D,G,H,P,V,z,N,re;if(b>=C&&b>=E?(U=c,G=d,V=p,re=m,c>=0?(x=l,M=u,I=h,D=f,H=v,P=g,z=y,N=A):(x=u,M=l,I=f,D=h,H=g,P=v,z=A,N=y)):C>=E?(U=l,G=h,V=v,re=y,l>=0?(x=u,M=c,I=f,D=d,H=g,P=p,z=A,N=m):(x=c,M=u,I=d,D=f,H=p,P=g,z=m,N=A)):(U=u,G=f,V=g,re=A,u>=0?(x=c,M=l,I=d,D=h,H=p,P=v,z=m,N=y):(x=l,M=c,I=h,D=d,H=v,P=p,z=y,N=m)),U===0)return null;let q=x/U,$=M/U,te=1/U,ue=I-q*G,de=D-$*G,K=H-q*V,xe=P-$*V,be=z-q*re,Pe=N-$*re,Ee=be*xe-Pe*K,Ve=ue*Pe-de*be,Qe=K*de-xe*ue;if(s){if(Ee<0||Ve<0||Qe<0)return null}else if((Ee<0||Ve<0||Qe<0)&&(Ee>0||Ve>0||Qe>0))return null;let Ge=Ee+Ve+Qe;if(Ge===0)return null;let ct=te*(Ee*G+Ve*V+Qe*re);return(Ge>0?ct<0:ct>0)?null:this.at(ct/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ss=class extends er{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new vt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=Fc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},pg=new Qt,Cr=new _c,Xl=new Po,mg=new ee,ql=new ee,Yl=new ee,$l=new ee,bd=new ee,Zl=new ee,gg=new ee,Jl=new ee,Nn=class extends Vn{constructor(e=new vi,t=new ss){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Zl.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let u=a[c],d=r[c];u!==0&&(bd.fromBufferAttribute(d,e),o?Zl.addScaledVector(bd,u):Zl.addScaledVector(bd.sub(t),u))}t.add(Zl)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Xl.copy(n.boundingSphere),Xl.applyMatrix4(r),Cr.copy(e.ray).recast(e.near),!(Xl.containsPoint(Cr.origin)===!1&&(Cr.intersectSphere(Xl,mg)===null||Cr.origin.distanceToSquared(mg)>(e.far-e.near)**2))&&(pg.copy(r).invert(),Cr.copy(e.ray).applyMatrix4(pg),!(n.boundingBox!==null&&Cr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Cr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,v=h.length;p<v;p++){let g=h[p],m=o[g.materialIndex],y=Math.max(g.start,f.start),A=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let b=y,C=A;b<C;b+=3){let E=a.getX(b),x=a.getX(b+1),M=a.getX(b+2);s=Kl(this,m,e,n,l,u,d,E,x,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let y=a.getX(g),A=a.getX(g+1),b=a.getX(g+2);s=Kl(this,o,e,n,l,u,d,y,A,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,v=h.length;p<v;p++){let g=h[p],m=o[g.materialIndex],y=Math.max(g.start,f.start),A=Math.min(c.count,Math.min(g.start+g.count,f.start+f.count));for(let b=y,C=A;b<C;b+=3){let E=b,x=b+1,M=b+2;s=Kl(this,m,e,n,l,u,d,E,x,M),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(c.count,f.start+f.count);for(let g=p,m=v;g<m;g+=3){let y=g,A=g+1,b=g+2;s=Kl(this,o,e,n,l,u,d,y,A,b),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function py(i,e,t,n,s,r,o,a){let c;if(e.side===Qn?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,e.side===or,a),c===null)return null;Jl.copy(a),Jl.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(Jl);return l<t.near||l>t.far?null:{distance:l,point:Jl.clone(),object:i}}function Kl(i,e,t,n,s,r,o,a,c,l){i.getVertexPosition(a,ql),i.getVertexPosition(c,Yl),i.getVertexPosition(l,$l);let u=py(i,e,t,n,ql,Yl,$l,gg);if(u){let d=new ee;js.getBarycoord(gg,ql,Yl,$l,d),s&&(u.uv=js.getInterpolatedAttribute(s,a,c,l,d,new St)),r&&(u.uv1=js.getInterpolatedAttribute(r,a,c,l,d,new St)),o&&(u.normal=js.getInterpolatedAttribute(o,a,c,l,d,new ee),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:c,c:l,normal:new ee,materialIndex:0};js.getNormal(ql,Yl,$l,h.normal),u.face=h,u.barycoord=d}return u}var vc=class extends jn{constructor(e=null,t=1,n=1,s,r,o,a,c,l=Dn,u=Dn,d,h){super(null,o,a,c,l,u,s,r,d,h),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Pr=new Po,my=new St(.5,.5),jl=new ee,tr=class{constructor(e=new zi,t=new zi,n=new zi,s=new zi,r=new zi,o=new zi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ai,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],c=r[2],l=r[3],u=r[4],d=r[5],h=r[6],f=r[7],p=r[8],v=r[9],g=r[10],m=r[11],y=r[12],A=r[13],b=r[14],C=r[15];if(s[0].setComponents(l-o,f-u,m-p,C-y).normalize(),s[1].setComponents(l+o,f+u,m+p,C+y).normalize(),s[2].setComponents(l+a,f+d,m+v,C+A).normalize(),s[3].setComponents(l-a,f-d,m-v,C-A).normalize(),n)s[4].setComponents(c,h,g,b).normalize(),s[5].setComponents(l-c,f-h,m-g,C-b).normalize();else if(s[4].setComponents(l-c,f-h,m-g,C-b).normalize(),t===Ai)s[5].setComponents(l+c,f+h,m+g,C+b).normalize();else if(t===Eo)s[5].setComponents(c,h,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Pr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Pr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Pr)}intersectsSprite(e){Pr.center.set(0,0,0);let t=my.distanceTo(e.center);return Pr.radius=.7071067811865476+t,Pr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Pr)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(jl.x=s.normal.x>0?e.max.x:e.min.x,jl.y=s.normal.y>0?e.max.y:e.min.y,jl.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(jl)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},xg=new Qt,yc=class i{constructor(){this.coordinateSystem=Ai,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];xg.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new tr),n[s].setFromProjectionMatrix(xg,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new tr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var La=class extends jn{constructor(e=[],t=Dr,n,s,r,o,a,c,l,u){super(e,t,n,s,r,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Da=class extends jn{constructor(e,t,n,s,r,o,a,c,l){super(e,t,n,s,r,o,a,c,l),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ss=class extends jn{constructor(e,t,n=Gi,s,r,o,a=Dn,c=Dn,l,u=bs,d=1){if(u!==bs&&u!==Ts)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:d};super(h,s,r,o,a,c,u,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Ro(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Na=class extends Ss{constructor(e,t=Gi,n=Dr,s,r,o=Dn,a=Dn,c,l=bs){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,c,l),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ua=class extends jn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},nr=class i extends vi{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],u=[],d=[],h=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new en(l,3)),this.setAttribute("normal",new en(u,3)),this.setAttribute("uv",new en(d,2));function p(v,g,m,y,A,b,C,E,x,M,U){let I=b/x,D=C/M,G=b/2,H=C/2,P=E/2,V=x+1,z=M+1,N=0,re=0,q=new ee;for(let $=0;$<z;$++){let te=$*D-H;for(let ue=0;ue<V;ue++){let de=ue*I-G;q[v]=de*y,q[g]=te*A,q[m]=P,l.push(q.x,q.y,q.z),q[v]=0,q[g]=0,q[m]=E>0?1:-1,u.push(q.x,q.y,q.z),d.push(ue/x),d.push(1-$/M),N+=1}}for(let $=0;$<M;$++)for(let te=0;te<x;te++){let ue=h+te+V*$,de=h+te+V*($+1),K=h+(te+1)+V*($+1),xe=h+(te+1)+V*$;c.push(ue,de,xe),c.push(de,K,xe),re+=6}a.addGroup(f,re,U),f+=re,h+=N}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Io=class i extends vi{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],c=[],l=new ee,u=new St;o.push(0,0,0),a.push(0,0,1),c.push(.5,.5);for(let d=0,h=3;d<=t;d++,h+=3){let f=n+d/t*s;l.x=e*Math.cos(f),l.y=e*Math.sin(f),o.push(l.x,l.y,l.z),a.push(0,0,1),u.x=(o[h]/e+1)/2,u.y=(o[h+1]/e+1)/2,c.push(u.x,u.y)}for(let d=1;d<=t;d++)r.push(d,d+1,0);this.setIndex(r),this.setAttribute("position",new en(o,3)),this.setAttribute("normal",new en(a,3)),this.setAttribute("uv",new en(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},Lo=class i extends vi{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],h=[],f=[],p=0,v=[],g=n/2,m=0;y(),o===!1&&(e>0&&A(!0),t>0&&A(!1)),this.setIndex(u),this.setAttribute("position",new en(d,3)),this.setAttribute("normal",new en(h,3)),this.setAttribute("uv",new en(f,2));function y(){let b=new ee,C=new ee,E=0,x=(t-e)/n;for(let M=0;M<=r;M++){let U=[],I=M/r,D=I*(t-e)+e;for(let G=0;G<=s;G++){let H=G/s,P=H*c+a,V=Math.sin(P),z=Math.cos(P);C.x=D*V,C.y=-I*n+g,C.z=D*z,d.push(C.x,C.y,C.z),b.set(V,x,z).normalize(),h.push(b.x,b.y,b.z),f.push(H,1-I),U.push(p++)}v.push(U)}for(let M=0;M<s;M++)for(let U=0;U<r;U++){let I=v[U][M],D=v[U+1][M],G=v[U+1][M+1],H=v[U][M+1];(e>0||U!==0)&&(u.push(I,D,H),E+=3),(t>0||U!==r-1)&&(u.push(D,G,H),E+=3)}l.addGroup(m,E,0),m+=E}function A(b){let C=p,E=new St,x=new ee,M=0,U=b===!0?e:t,I=b===!0?1:-1;for(let G=1;G<=s;G++)d.push(0,g*I,0),h.push(0,I,0),f.push(.5,.5),p++;let D=p;for(let G=0;G<=s;G++){let P=G/s*c+a,V=Math.cos(P),z=Math.sin(P);x.x=U*z,x.y=g*I,x.z=U*V,d.push(x.x,x.y,x.z),h.push(0,I,0),E.x=V*.5+.5,E.y=z*.5*I+.5,f.push(E.x,E.y),p++}for(let G=0;G<s;G++){let H=C+G,P=D+G;b===!0?u.push(P,P+1,H):u.push(P+1,P,H),M+=3}l.addGroup(m,M,b===!0?1:2),m+=M}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Fa=class i extends Lo{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Oa=class i extends vi{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),c=Math.floor(s),l=a+1,u=c+1,d=e/a,h=t/c,f=[],p=[],v=[],g=[];for(let m=0;m<u;m++){let y=m*h-o;for(let A=0;A<l;A++){let b=A*d-r;p.push(b,-y,0),v.push(0,0,1),g.push(A/a),g.push(1-m/c)}}for(let m=0;m<c;m++)for(let y=0;y<a;y++){let A=y+l*m,b=y+l*(m+1),C=y+1+l*(m+1),E=y+1+l*m;f.push(A,b,E),f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new en(p,3)),this.setAttribute("normal",new en(v,3)),this.setAttribute("uv",new en(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ba=class i extends vi{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let c=[],l=[],u=[],d=[],h=new ee,f=new ee,p=new ee;for(let v=0;v<=n;v++){let g=o+v/n*a;for(let m=0;m<=s;m++){let y=m/s*r;f.x=(e+t*Math.cos(g))*Math.cos(y),f.y=(e+t*Math.cos(g))*Math.sin(y),f.z=t*Math.sin(g),l.push(f.x,f.y,f.z),h.x=e*Math.cos(y),h.y=e*Math.sin(y),p.subVectors(f,h).normalize(),u.push(p.x,p.y,p.z),d.push(m/s),d.push(v/n)}}for(let v=1;v<=n;v++)for(let g=1;g<=s;g++){let m=(s+1)*v+g-1,y=(s+1)*(v-1)+g-1,A=(s+1)*(v-1)+g,b=(s+1)*v+g;c.push(m,y,b),c.push(y,A,b)}this.setIndex(c),this.setAttribute("position",new en(l,3)),this.setAttribute("normal",new en(u,3)),this.setAttribute("uv",new en(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function Ur(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(_g(s))s.isRenderTargetTexture?(ot("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(_g(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Hn(i){let e={};for(let t=0;t<i.length;t++){let n=Ur(i[t]);for(let s in n)e[s]=n[s]}return e}function _g(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function gy(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function sf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Et.workingColorSpace}var u0={clone:Ur,merge:Hn},xy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,_y=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,rs=class extends er{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=xy,this.fragmentShader=_y,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Ur(e.uniforms),this.uniformsGroups=gy(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new vt().setHex(s.value);break;case"v2":this.uniforms[n].value=new St().fromArray(s.value);break;case"v3":this.uniforms[n].value=new ee().fromArray(s.value);break;case"v4":this.uniforms[n].value=new tn().fromArray(s.value);break;case"m3":this.uniforms[n].value=new dt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Qt().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},bc=class extends rs{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Do=class extends er{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new vt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new vt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Mu,this.normalScale=new St(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Ms,this.combine=Fc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Mc=class extends er{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Zg,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Sc=class extends er{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function bo(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function Ql(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var ir=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},wc=class extends ir{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:wd,endingEnd:wd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Td:r=e,a=2*t-n;break;case Ed:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Td:o=e,c=2*n-t;break;case Ed:o=1,c=n+s[1]-s[0];break;default:o=e-1,c=t}let l=(n-t)*.5,u=this.valueSize;this._weightPrev=l/(t-a),this._weightNext=l/(c-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),v=p*p,g=v*p,m=-h*g+2*h*v-h*p,y=(1+h)*g+(-1.5-2*h)*v+(-.5+h)*p+1,A=(-1-f)*g+(1.5+f)*v+.5*p,b=f*g-f*v;for(let C=0;C!==a;++C)r[C]=m*o[u+C]+y*o[l+C]+A*o[c+C]+b*o[d+C];return r}},Tc=class extends ir{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=(n-t)/(s-t),d=1-u;for(let h=0;h!==a;++h)r[h]=o[l+h]*d+o[c+h]*u;return r}},Ec=class extends ir{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Ac=class extends ir{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let p=(n-t)/(s-t),v=1-p;for(let g=0;g!==a;++g)r[g]=o[l+g]*v+o[c+g]*p;return r}let h=a*2,f=e-1;for(let p=0;p!==a;++p){let v=o[l+p],g=o[c+p],m=f*h+p*2,y=d[m],A=d[m+1],b=e*h+p*2,C=u[b],E=u[b+1],x=yy(n,t,y,C,s);r[p]=h0(x,v,A,E,g)}return r}};function h0(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function vy(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function yy(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=h0(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let c=vy(r,e,t,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var yi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=bo(t,this.TimeBufferType),this.values=bo(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:bo(e.times,Array),values:bo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),Ql(e.settings)&&(n.settings={inTangents:bo(e.settings.inTangents,Array),outTangents:bo(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Ec(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Tc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new wc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Ac(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Sa:t=this.InterpolantFactoryMethodDiscrete;break;case fc:t=this.InterpolantFactoryMethodLinear;break;case nc:t=this.InterpolantFactoryMethodSmooth;break;case Sd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return ot("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Sa;case this.InterpolantFactoryMethodLinear:return fc;case this.InterpolantFactoryMethodSmooth:return nc;case this.InterpolantFactoryMethodBezier:return Sd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;Ql(this.settings)&&(vg(this.settings.inTangents,e),vg(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;Ql(this.settings)&&(yg(this.settings.inTangents,e),yg(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(lt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(lt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){lt("KeyframeTrack: Time is not a valid number.",this,a,c),e=!1;break}if(o!==null&&o>c){lt("KeyframeTrack: Out of order keys.",this,a,c,o),e=!1;break}o=c}if(s!==void 0&&$v(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){lt("KeyframeTrack: Value is not a valid number.",this,a,l),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===nc,r=e.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=e[a],u=e[a+1];if(l!==u&&(a!==1||l!==e[0]))if(s)c=!0;else{let d=a*n,h=d-n,f=d+n;for(let p=0;p!==n;++p){let v=t[d+p];if(v!==t[h+p]||v!==t[f+p]){c=!0;break}}}if(c){if(a!==o){e[o]=e[a];let d=a*n,h=o*n;for(let f=0;f!==n;++f)t[h+f]=t[d+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)t[c+l]=t[a+l];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,Ql(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function vg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function yg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}yi.prototype.ValueTypeName="";yi.prototype.TimeBufferType=Float32Array;yi.prototype.ValueBufferType=Float32Array;yi.prototype.DefaultInterpolation=fc;var sr=class extends yi{constructor(e,t,n){super(e,t,n)}};sr.prototype.ValueTypeName="bool";sr.prototype.ValueBufferType=Array;sr.prototype.DefaultInterpolation=Sa;sr.prototype.InterpolantFactoryMethodLinear=void 0;sr.prototype.InterpolantFactoryMethodSmooth=void 0;var Rc=class extends yi{constructor(e,t,n,s){super(e,t,n,s)}};Rc.prototype.ValueTypeName="color";var Cc=class extends yi{constructor(e,t,n,s){super(e,t,n,s)}};Cc.prototype.ValueTypeName="number";var Pc=class extends ir{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-t)/(s-t),l=e*a;for(let u=l+a;l!==u;l+=4)is.slerpFlat(r,0,o,l-a,o,l,c);return r}},ka=class extends yi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Pc(this.times,this.values,this.getValueSize(),e)}};ka.prototype.ValueTypeName="quaternion";ka.prototype.InterpolantFactoryMethodSmooth=void 0;var rr=class extends yi{constructor(e,t,n){super(e,t,n)}};rr.prototype.ValueTypeName="string";rr.prototype.ValueBufferType=Array;rr.prototype.DefaultInterpolation=Sa;rr.prototype.InterpolantFactoryMethodLinear=void 0;rr.prototype.InterpolantFactoryMethodSmooth=void 0;var Ic=class extends yi{constructor(e,t,n,s){super(e,t,n,s)}};Ic.prototype.ValueTypeName="vector";var Lc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,d){return l.push(u,d),this},this.removeHandler=function(u){let d=l.indexOf(u);return d!==-1&&l.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=l.length;d<h;d+=2){let f=l[d],p=l[d+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},d0=new Lc,Dc=class{constructor(e){this.manager=e!==void 0?e:d0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Dc.DEFAULT_MATERIAL_NAME="__DEFAULT";var za=class extends Vn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new vt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Ga=class extends za{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new vt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Md=new Qt,bg=new ee,Mg=new ee,Nc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new St(512,512),this.mapType=si,this.map=null,this.mapPass=null,this.matrix=new Qt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new tr,this._frameExtents=new St(1,1),this._viewportCount=1,this._viewports=[new tn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;bg.setFromMatrixPosition(e.matrixWorld),t.position.copy(bg),Mg.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Mg),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Md.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Md,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;e.coordinateSystem===Eo||e.reversedDepth?t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),t.multiply(Md)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},ec=new ee,tc=new is,es=new ee,Va=class extends Vn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qt,this.projectionMatrix=new Qt,this.projectionMatrixInverse=new Qt,this.coordinateSystem=Ai,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ec,tc,es),es.x===1&&es.y===1&&es.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ec,tc,es.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(ec,tc,es),es.x===1&&es.y===1&&es.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ec,tc,es.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ks=new ee,Sg=new St,wg=new St,Jn=class extends Va{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=pc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(td*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return pc*2*Math.atan(Math.tan(td*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ks.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ks.x,Ks.y).multiplyScalar(-e/Ks.z),Ks.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ks.x,Ks.y).multiplyScalar(-e/Ks.z)}getViewSize(e,t){return this.getViewBounds(e,Sg,wg),t.subVectors(wg,Sg)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(td*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,t-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ha=class extends Va{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,c=s-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Ad=class extends Nc{constructor(){super(new Ha(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Wa=class extends za{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.target=new Vn,this.shadow=new Ad}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Mo=-90,So=1,No=class extends Vn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Jn(Mo,So,e,t);s.layers=this.layers,this.add(s);let r=new Jn(Mo,So,e,t);r.layers=this.layers,this.add(r);let o=new Jn(Mo,So,e,t);o.layers=this.layers,this.add(o);let a=new Jn(Mo,So,e,t);a.layers=this.layers,this.add(a);let c=new Jn(Mo,So,e,t);c.layers=this.layers,this.add(c);let l=new Jn(Mo,So,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,c]=t;for(let l of t)this.remove(l);if(e===Ai)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===Eo)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,u]=this.children,d=e.getRenderTarget(),h=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),n.texture.mipmapsAutoUpdate=v,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,h,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Uc=class extends Jn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var rf="\\[\\]\\.:\\/",by=new RegExp("["+rf+"]","g"),of="[^"+rf+"]",My="[^"+rf.replace("\\.","")+"]",Sy=/((?:WC+[\/:])*)/.source.replace("WC",of),wy=/(WCOD+)?/.source.replace("WCOD",My),Ty=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",of),Ey=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",of),Ay=new RegExp("^"+Sy+wy+Ty+Ey+"$"),Ry=["material","materials","bones","map"],Rd=class{constructor(e,t,n){let s=n||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},Zt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(by,"")}static parseTrackName(e){let t=Ay.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Ry.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let c=n(a.children);if(c)return c}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){ot("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=t.objectIndex;switch(n){case"materials":if(!e.material){lt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){lt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){lt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===l){l=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){lt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){lt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){lt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(l!==void 0){if(e[l]===void 0){lt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[l]}}let o=e[s];if(o===void 0){let l=t.nodeName;lt("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){lt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){lt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=Rd;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var SE=new Float32Array(1);var Cd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function af(i,e,t,n){let s=Cy(n);switch(t){case $d:return i*e;case Jd:return i*e/s.components*s.byteLength;case Hc:return i*e/s.components*s.byteLength;case ar:return i*e*2/s.components*s.byteLength;case Wc:return i*e*2/s.components*s.byteLength;case Zd:return i*e*3/s.components*s.byteLength;case Wi:return i*e*4/s.components*s.byteLength;case Xc:return i*e*4/s.components*s.byteLength;case Ya:case $a:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case Za:case Ja:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Yc:case Zc:return Math.max(i,16)*Math.max(e,8)/4;case qc:case $c:return Math.max(i,8)*Math.max(e,8)/2;case Jc:case Kc:case Qc:case eu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case jc:case Ka:case tu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case nu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case iu:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case su:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case ru:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case ou:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case au:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case lu:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case cu:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case uu:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case hu:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case du:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case fu:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case pu:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case mu:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case gu:case xu:case _u:return Math.ceil(i/4)*Math.ceil(e/4)*16;case vu:case yu:return Math.ceil(i/4)*Math.ceil(e/4)*8;case ja:case bu:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function Cy(i){switch(i){case si:case Wd:return{byteLength:1,components:1};case Bo:case Xd:case Hi:return{byteLength:2,components:1};case Gc:case Vc:return{byteLength:2,components:4};case Gi:case zc:case Vi:return{byteLength:4,components:1};case qd:case Yd:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ot("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function N0(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function By(i){let e=new WeakMap;function t(a,c){let l=a.array,u=a.usage,d=l.byteLength,h=i.createBuffer();i.bindBuffer(c,h),i.bufferData(c,l,u),a.onUploadCallback();let f;if(l instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=i.SHORT;else if(l instanceof Uint32Array)f=i.UNSIGNED_INT;else if(l instanceof Int32Array)f=i.INT;else if(l instanceof Int8Array)f=i.BYTE;else if(l instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:h,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,c,l){let u=c.array,d=c.updateRanges;if(i.bindBuffer(l,a),d.length===0)i.bufferSubData(l,0,u);else{d.sort((f,p)=>f.start-p.start);let h=0;for(let f=1;f<d.length;f++){let p=d[h],v=d[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++h,d[h]=v)}d.length=h+1;for(let f=0,p=d.length;f<p;f++){let v=d[f];i.bufferSubData(l,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(i.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var ky=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,zy=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Gy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Vy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Hy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Wy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Xy=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,qy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Yy=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,$y=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Zy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Jy=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Ky=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,jy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,Qy=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,eb=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,tb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,nb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ib=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,sb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,rb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,ob=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,ab=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,lb=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,cb=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,ub=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,hb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,db=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,fb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,pb="gl_FragColor = linearToOutputTexel( gl_FragColor );",mb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,gb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,xb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,_b=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,vb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,yb=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,bb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Mb=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Sb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,wb=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Tb=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Eb=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Ab=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Rb=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Cb=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Pb=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Ib=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Lb=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Db=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Nb=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Ub=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Fb=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Ob=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Bb=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,kb=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,zb=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Gb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Vb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Hb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Wb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Xb=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,qb=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Yb=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,$b=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Zb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Jb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Kb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,jb=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Qb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,eM=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,tM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,nM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,iM=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,sM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,rM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,oM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,aM=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,lM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,cM=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,uM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,hM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,dM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,fM=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,pM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,mM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,gM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,xM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,_M=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,vM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,yM=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,bM=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,MM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,SM=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,wM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,TM=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,EM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,AM=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,RM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,CM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,PM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,IM=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,LM=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,DM=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,NM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,UM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,FM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,OM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,BM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,kM=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,zM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,GM=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,HM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,WM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,XM=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,qM=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,YM=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,$M=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ZM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,JM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,KM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,jM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,QM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,eS=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,tS=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,nS=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,iS=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,sS=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,rS=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,oS=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,aS=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,lS=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,cS=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,uS=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,hS=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,dS=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,fS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,pS=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,mS=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,gS=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,xS=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,xt={alphahash_fragment:ky,alphahash_pars_fragment:zy,alphamap_fragment:Gy,alphamap_pars_fragment:Vy,alphatest_fragment:Hy,alphatest_pars_fragment:Wy,aomap_fragment:Xy,aomap_pars_fragment:qy,batching_pars_vertex:Yy,batching_vertex:$y,begin_vertex:Zy,beginnormal_vertex:Jy,bsdfs:Ky,iridescence_fragment:jy,bumpmap_pars_fragment:Qy,clipping_planes_fragment:eb,clipping_planes_pars_fragment:tb,clipping_planes_pars_vertex:nb,clipping_planes_vertex:ib,color_fragment:sb,color_pars_fragment:rb,color_pars_vertex:ob,color_vertex:ab,common:lb,defaultnormal_vertex:cb,displacementmap_pars_vertex:ub,displacementmap_vertex:hb,emissivemap_fragment:db,emissivemap_pars_fragment:fb,colorspace_fragment:pb,colorspace_pars_fragment:mb,envmap_fragment:gb,envmap_common_pars_fragment:xb,envmap_pars_fragment:_b,envmap_pars_vertex:vb,envmap_physical_pars_fragment:Pb,envmap_vertex:yb,fog_vertex:bb,fog_pars_vertex:Mb,fog_fragment:Sb,fog_pars_fragment:wb,gradientmap_pars_fragment:Tb,lightmap_pars_fragment:Eb,lights_lambert_fragment:Ab,lights_lambert_pars_fragment:Rb,lights_pars_begin:Cb,lights_toon_fragment:Ib,lights_toon_pars_fragment:Lb,lights_phong_fragment:Db,lights_phong_pars_fragment:Nb,lights_physical_fragment:Ub,lights_physical_pars_fragment:Fb,lights_fragment_begin:Ob,lights_fragment_maps:Bb,lights_fragment_end:kb,lightprobes_pars_fragment:zb,logdepthbuf_fragment:Gb,logdepthbuf_pars_fragment:Vb,logdepthbuf_pars_vertex:Hb,logdepthbuf_vertex:Wb,map_fragment:Xb,map_pars_fragment:qb,map_particle_fragment:Yb,map_particle_pars_fragment:$b,metalnessmap_fragment:Zb,metalnessmap_pars_fragment:Jb,morphinstance_vertex:Kb,morphcolor_vertex:jb,morphnormal_vertex:Qb,morphtarget_pars_vertex:eM,morphtarget_vertex:tM,normal_fragment_begin:nM,normal_fragment_maps:iM,normal_pars_fragment:sM,normal_pars_vertex:rM,normal_vertex:oM,normalmap_pars_fragment:aM,clearcoat_normal_fragment_begin:lM,clearcoat_normal_fragment_maps:cM,clearcoat_pars_fragment:uM,iridescence_pars_fragment:hM,opaque_fragment:dM,packing:fM,premultiplied_alpha_fragment:pM,project_vertex:mM,dithering_fragment:gM,dithering_pars_fragment:xM,roughnessmap_fragment:_M,roughnessmap_pars_fragment:vM,shadowmap_pars_fragment:yM,shadowmap_pars_vertex:bM,shadowmap_vertex:MM,shadowmask_pars_fragment:SM,skinbase_vertex:wM,skinning_pars_vertex:TM,skinning_vertex:EM,skinnormal_vertex:AM,specularmap_fragment:RM,specularmap_pars_fragment:CM,tonemapping_fragment:PM,tonemapping_pars_fragment:IM,transmission_fragment:LM,transmission_pars_fragment:DM,uv_pars_fragment:NM,uv_pars_vertex:UM,uv_vertex:FM,worldpos_vertex:OM,background_vert:BM,background_frag:kM,backgroundCube_vert:zM,backgroundCube_frag:GM,cube_vert:VM,cube_frag:HM,depth_vert:WM,depth_frag:XM,distance_vert:qM,distance_frag:YM,equirect_vert:$M,equirect_frag:ZM,linedashed_vert:JM,linedashed_frag:KM,meshbasic_vert:jM,meshbasic_frag:QM,meshlambert_vert:eS,meshlambert_frag:tS,meshmatcap_vert:nS,meshmatcap_frag:iS,meshnormal_vert:sS,meshnormal_frag:rS,meshphong_vert:oS,meshphong_frag:aS,meshphysical_vert:lS,meshphysical_frag:cS,meshtoon_vert:uS,meshtoon_frag:hS,points_vert:dS,points_frag:fS,shadow_vert:pS,shadow_frag:mS,sprite_vert:gS,sprite_frag:xS},Oe={common:{diffuse:{value:new vt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new dt},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new dt}},envmap:{envMap:{value:null},envMapRotation:{value:new dt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new dt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new dt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new dt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new dt},normalScale:{value:new St(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new dt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new dt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new dt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new dt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new vt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new vt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0},uvTransform:{value:new dt}},sprite:{diffuse:{value:new vt(16777215)},opacity:{value:1},center:{value:new St(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new dt},alphaMap:{value:null},alphaMapTransform:{value:new dt},alphaTest:{value:0}}},ls={basic:{uniforms:Hn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.fog]),vertexShader:xt.meshbasic_vert,fragmentShader:xt.meshbasic_frag},lambert:{uniforms:Hn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,Oe.lights,{emissive:{value:new vt(0)},envMapIntensity:{value:1}}]),vertexShader:xt.meshlambert_vert,fragmentShader:xt.meshlambert_frag},phong:{uniforms:Hn([Oe.common,Oe.specularmap,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,Oe.lights,{emissive:{value:new vt(0)},specular:{value:new vt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:xt.meshphong_vert,fragmentShader:xt.meshphong_frag},standard:{uniforms:Hn([Oe.common,Oe.envmap,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.roughnessmap,Oe.metalnessmap,Oe.fog,Oe.lights,{emissive:{value:new vt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:xt.meshphysical_vert,fragmentShader:xt.meshphysical_frag},toon:{uniforms:Hn([Oe.common,Oe.aomap,Oe.lightmap,Oe.emissivemap,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.gradientmap,Oe.fog,Oe.lights,{emissive:{value:new vt(0)}}]),vertexShader:xt.meshtoon_vert,fragmentShader:xt.meshtoon_frag},matcap:{uniforms:Hn([Oe.common,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,Oe.fog,{matcap:{value:null}}]),vertexShader:xt.meshmatcap_vert,fragmentShader:xt.meshmatcap_frag},points:{uniforms:Hn([Oe.points,Oe.fog]),vertexShader:xt.points_vert,fragmentShader:xt.points_frag},dashed:{uniforms:Hn([Oe.common,Oe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:xt.linedashed_vert,fragmentShader:xt.linedashed_frag},depth:{uniforms:Hn([Oe.common,Oe.displacementmap]),vertexShader:xt.depth_vert,fragmentShader:xt.depth_frag},normal:{uniforms:Hn([Oe.common,Oe.bumpmap,Oe.normalmap,Oe.displacementmap,{opacity:{value:1}}]),vertexShader:xt.meshnormal_vert,fragmentShader:xt.meshnormal_frag},sprite:{uniforms:Hn([Oe.sprite,Oe.fog]),vertexShader:xt.sprite_vert,fragmentShader:xt.sprite_frag},background:{uniforms:{uvTransform:{value:new dt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:xt.background_vert,fragmentShader:xt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new dt}},vertexShader:xt.backgroundCube_vert,fragmentShader:xt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:xt.cube_vert,fragmentShader:xt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:xt.equirect_vert,fragmentShader:xt.equirect_frag},distance:{uniforms:Hn([Oe.common,Oe.displacementmap,{referencePosition:{value:new ee},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:xt.distance_vert,fragmentShader:xt.distance_frag},shadow:{uniforms:Hn([Oe.lights,Oe.fog,{color:{value:new vt(0)},opacity:{value:1}}]),vertexShader:xt.shadow_vert,fragmentShader:xt.shadow_frag}};ls.physical={uniforms:Hn([ls.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new dt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new dt},clearcoatNormalScale:{value:new St(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new dt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new dt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new dt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new dt},sheen:{value:0},sheenColor:{value:new vt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new dt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new dt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new dt},transmissionSamplerSize:{value:new St},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new dt},attenuationDistance:{value:0},attenuationColor:{value:new vt(0)},specularColor:{value:new vt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new dt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new dt},anisotropyVector:{value:new St},anisotropyMap:{value:null},anisotropyMapTransform:{value:new dt}}]),vertexShader:xt.meshphysical_vert,fragmentShader:xt.meshphysical_frag};var Su={r:0,b:0,g:0},_S=new Qt,U0=new dt;U0.set(-1,0,0,0,1,0,0,0,1);function vS(i,e,t,n,s,r){let o=new vt(0),a=s===!0?0:1,c,l,u=null,d=0,h=null;function f(y){let A=y.isScene===!0?y.background:null;if(A&&A.isTexture){let b=y.backgroundBlurriness>0;A=e.get(A,b)}return A}function p(y){let A=!1,b=f(y);b===null?g(o,a):b&&b.isColor&&(g(b,1),A=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function v(y,A){let b=f(A);b&&b.isCubeTexture?(l===void 0&&(l=new Nn(new nr(1,1,1),new rs({name:"BackgroundCubeMaterial",uniforms:Ur(ls.backgroundCube.uniforms),vertexShader:ls.backgroundCube.vertexShader,fragmentShader:ls.backgroundCube.fragmentShader,side:Qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(C,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=b,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(_S.makeRotationFromEuler(A.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(U0),l.material.toneMapped=Et.getTransfer(b.colorSpace)!==Ut,(u!==b||d!==b.version||h!==i.toneMapping)&&(l.material.needsUpdate=!0,u=b,d=b.version,h=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null)):b&&b.isTexture&&(c===void 0&&(c=new Nn(new Oa(2,2),new rs({name:"BackgroundMaterial",uniforms:Ur(ls.background.uniforms),vertexShader:ls.background.vertexShader,fragmentShader:ls.background.fragmentShader,side:or,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=b,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=Et.getTransfer(b.colorSpace)!==Ut,b.matrixAutoUpdate===!0&&b.updateMatrix(),c.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||d!==b.version||h!==i.toneMapping)&&(c.material.needsUpdate=!0,u=b,d=b.version,h=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function g(y,A){y.getRGB(Su,sf(i)),t.buffers.color.setClear(Su.r,Su.g,Su.b,A,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,A=1){o.set(y),a=A,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:p,addToRenderList:v,dispose:m}}function yS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=h(null),r=s,o=!1;function a(D,G,H,P,V){let z=!1,N=d(D,P,H,G);r!==N&&(r=N,l(r.object)),z=f(D,P,H,V),z&&p(D,P,H,V),V!==null&&e.update(V,i.ELEMENT_ARRAY_BUFFER),(z||o)&&(o=!1,b(D,G,H,P),V!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function c(){return i.createVertexArray()}function l(D){return i.bindVertexArray(D)}function u(D){return i.deleteVertexArray(D)}function d(D,G,H,P){let V=P.wireframe===!0,z=n[G.id];z===void 0&&(z={},n[G.id]=z);let N=D.isInstancedMesh===!0?D.id:0,re=z[N];re===void 0&&(re={},z[N]=re);let q=re[H.id];q===void 0&&(q={},re[H.id]=q);let $=q[V];return $===void 0&&($=h(c()),q[V]=$),$}function h(D){let G=[],H=[],P=[];for(let V=0;V<t;V++)G[V]=0,H[V]=0,P[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:H,attributeDivisors:P,object:D,attributes:{},index:null}}function f(D,G,H,P){let V=r.attributes,z=G.attributes,N=0,re=H.getAttributes();for(let q in re)if(re[q].location>=0){let te=V[q],ue=z[q];if(ue===void 0&&(q==="instanceMatrix"&&D.instanceMatrix&&(ue=D.instanceMatrix),q==="instanceColor"&&D.instanceColor&&(ue=D.instanceColor)),te===void 0||te.attribute!==ue||ue&&te.data!==ue.data)return!0;N++}return r.attributesNum!==N||r.index!==P}function p(D,G,H,P){let V={},z=G.attributes,N=0,re=H.getAttributes();for(let q in re)if(re[q].location>=0){let te=z[q];te===void 0&&(q==="instanceMatrix"&&D.instanceMatrix&&(te=D.instanceMatrix),q==="instanceColor"&&D.instanceColor&&(te=D.instanceColor));let ue={};ue.attribute=te,te&&te.data&&(ue.data=te.data),V[q]=ue,N++}r.attributes=V,r.attributesNum=N,r.index=P}function v(){let D=r.newAttributes;for(let G=0,H=D.length;G<H;G++)D[G]=0}function g(D){m(D,0)}function m(D,G){let H=r.newAttributes,P=r.enabledAttributes,V=r.attributeDivisors;H[D]=1,P[D]===0&&(i.enableVertexAttribArray(D),P[D]=1),V[D]!==G&&(i.vertexAttribDivisor(D,G),V[D]=G)}function y(){let D=r.newAttributes,G=r.enabledAttributes;for(let H=0,P=G.length;H<P;H++)G[H]!==D[H]&&(i.disableVertexAttribArray(H),G[H]=0)}function A(D,G,H,P,V,z,N){N===!0?i.vertexAttribIPointer(D,G,H,V,z):i.vertexAttribPointer(D,G,H,P,V,z)}function b(D,G,H,P){v();let V=P.attributes,z=H.getAttributes(),N=G.defaultAttributeValues;for(let re in z){let q=z[re];if(q.location>=0){let $=V[re];if($===void 0&&(re==="instanceMatrix"&&D.instanceMatrix&&($=D.instanceMatrix),re==="instanceColor"&&D.instanceColor&&($=D.instanceColor)),$!==void 0){let te=$.normalized,ue=$.itemSize,de=e.get($);if(de===void 0)continue;let K=de.buffer,xe=de.type,be=de.bytesPerElement,Pe=xe===i.INT||xe===i.UNSIGNED_INT||$.gpuType===zc;if($.isInterleavedBufferAttribute){let Ee=$.data,Ve=Ee.isInterleavedBuffer===!0?Ee.stride:Ee.itemSize,Qe=$.offset;if(Ee.isInstancedInterleavedBuffer||Ee.isInstancedBufferAttribute){for(let Ge=0;Ge<q.locationSize;Ge++)m(q.location+Ge,Ee.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Ee.meshPerAttribute*Ee.count)}else for(let Ge=0;Ge<q.locationSize;Ge++)g(q.location+Ge);i.bindBuffer(i.ARRAY_BUFFER,K);for(let Ge=0;Ge<q.locationSize;Ge++)A(q.location+Ge,ue/q.locationSize,xe,te,Ve*be,(Qe+ue/q.locationSize*Ge)*be,Pe)}else{if($.isInstancedBufferAttribute){for(let Ee=0;Ee<q.locationSize;Ee++)m(q.location+Ee,$.meshPerAttribute);D.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=$.meshPerAttribute*$.count)}else for(let Ee=0;Ee<q.locationSize;Ee++)g(q.location+Ee);i.bindBuffer(i.ARRAY_BUFFER,K);for(let Ee=0;Ee<q.locationSize;Ee++)A(q.location+Ee,ue/q.locationSize,xe,te,ue*be,ue/q.locationSize*Ee*be,Pe)}}else if(N!==void 0){let te=N[re];if(te!==void 0)switch(te.length){case 2:i.vertexAttrib2fv(q.location,te);break;case 3:i.vertexAttrib3fv(q.location,te);break;case 4:i.vertexAttrib4fv(q.location,te);break;default:i.vertexAttrib1fv(q.location,te)}}}}y()}function C(){U();for(let D in n){let G=n[D];for(let H in G){let P=G[H];for(let V in P){let z=P[V];for(let N in z)u(z[N].object),delete z[N];delete P[V]}}delete n[D]}}function E(D){if(n[D.id]===void 0)return;let G=n[D.id];for(let H in G){let P=G[H];for(let V in P){let z=P[V];for(let N in z)u(z[N].object),delete z[N];delete P[V]}}delete n[D.id]}function x(D){for(let G in n){let H=n[G];for(let P in H){let V=H[P];if(V[D.id]===void 0)continue;let z=V[D.id];for(let N in z)u(z[N].object),delete z[N];delete V[D.id]}}}function M(D){for(let G in n){let H=n[G],P=D.isInstancedMesh===!0?D.id:0,V=H[P];if(V!==void 0){for(let z in V){let N=V[z];for(let re in N)u(N[re].object),delete N[re];delete V[z]}delete H[P],Object.keys(H).length===0&&delete n[G]}}}function U(){I(),o=!0,r!==s&&(r=s,l(r.object))}function I(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:U,resetDefaultState:I,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:M,releaseStatesOfProgram:x,initAttributes:v,enableAttribute:g,disableUnusedAttributes:y}}function bS(i,e,t){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),t.update(l,n,1)}function o(c,l,u){u!==0&&(i.drawArraysInstanced(n,c,l,u),t.update(l,n,u))}function a(c,l,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,u);let h=0;for(let f=0;f<u;f++)h+=l[f];t.update(h,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function MS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Wi&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let M=x===Hi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==si&&x!==Vi&&!M&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",u=c(l);u!==l&&(ot("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&ot("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&ot("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:y,maxVaryings:A,maxFragmentUniforms:b,maxSamples:C,samples:E}}function SS(i){let e=this,t=null,n=0,s=!1,r=!1,o=new zi,a=new dt,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let f=d.length!==0||h||n!==0||s;return s=h,n=d.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){t=u(d,h,0)},this.setState=function(d,h,f){let p=d.clippingPlanes,v=d.clipIntersection,g=d.clipShadows,m=i.get(d);if(!s||p===null||p.length===0||r&&!g)r?u(null):l();else{let y=r?0:n,A=y*4,b=m.clippingState||null;c.value=b,b=u(p,h,A,f);for(let C=0;C!==A;++C)b[C]=t[C];m.clippingState=b,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=y}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(d,h,f,p){let v=d!==null?d.length:0,g=null;if(v!==0){if(g=c.value,p!==!0||g===null){let m=f+v*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<m)&&(g=new Float32Array(m));for(let A=0,b=f;A!==v;++A,b+=4)o.copy(d[A]).applyMatrix4(y,a),o.normal.toArray(g,b),g[b+3]=o.constant}c.value=g,c.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var nl=class extends _i{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new La(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new nr(5,5,5),r=new rs({name:"CubemapFromEquirect",uniforms:Ur(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Qn,blending:Ir});r.uniforms.tEquirect.value=t;let o=new Nn(s,r),a=t.minFilter;return t.minFilter===ws&&(t.minFilter=Kn),new No(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},f0=256,wS=3,TS=20,F0=256,O0=16,ES=3,AS=new ee,RS=new vt,Tu=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new No(1,10,null),this._boxMesh=new Nn(new nr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=AS}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let d=c.autoClear,h=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,v=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,v===null&&(e.background=c.getClearColor(RS));let g=new No(n,s,u);return g.position.copy(a),g.update(c,e),c.autoClear=d,c.autoClearColor=h,c.autoClearDepth=f,c.autoClearStencil=p,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=g0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=m0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(f0,l0(e))}_fromTexture(e,t){e.mapping===Dr||e.mapping===Oo?this._setSize(e.image.length===0?f0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=p0(e,!1,!1),n=Math.log2(e)-wS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=p0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Dr||e.mapping===Oo?(this._cubemapMaterial===null&&(this._cubemapMaterial=g0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=m0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=CS(),this._integrationMaterial=PS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/O0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-ES)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let c=a>0?Math.log2(t)+.5*Math.log2(6/(F0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=IS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function p0(i,e,t){return new nl(i,{minFilter:ws,generateMipmaps:e,type:Hi,colorSpace:wa,depthBuffer:t})}function il(i,e,t){return new rs({name:i,uniforms:e,vertexShader:xt.cube_vert,fragmentShader:t,side:Qn,blending:Ir,depthTest:!1,depthWrite:!1})}function CS(){return il("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${F0}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function PS(){return il("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:O0}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function IS(){return il("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${TS}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function m0(){return il("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function g0(){return il("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function LS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===Oc||f===Bc)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let v=new nl(p.height);return v.fromEquirectangularTexture(i,h),e.set(h,v),h.addEventListener("dispose",l),a(v.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.mapping,p=f===Oc||f===Bc,v=f===Dr||f===Oo;if(p||v){let g=t.get(h),m=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return n===null&&(n=new Tu(i)),g=p?n.fromEquirectangular(h,g):n.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let y=h.image;return p&&y&&y.height>0||v&&y&&c(y)?(n===null&&(n=new Tu(i)),g=p?n.fromEquirectangular(h):n.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,f){return f===Oc?h.mapping=Dr:f===Bc&&(h.mapping=Oo),h}function c(h){let f=0,p=6;for(let v=0;v<p;v++)h[v]!==void 0&&f++;return f===p}function l(h){let f=h.target;f.removeEventListener("dispose",l);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(h){let f=h.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function DS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Ma("WebGLRenderer: "+n+" extension not supported."),s}}}function NS(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let v=r.get(p);v&&(e.remove(v),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function l(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function u(p){let v=p.attributes;for(let g in v)e.update(v[g],i.ARRAY_BUFFER)}function d(p){let v=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let y=v!==null?v.array.length:g.array.length/3-1,A=g.count>=65535?Ia:Pa,b=new A(Math.ceil(y/3)*6,1),C=b.array;if(v!==null){let x=v.array;m=v.version;for(let M=0,U=0;M<y;M+=3){let I=x[M+0],D=x[M+1],G=x[M+2];C[U++]=I,C[U++]=D,C[U++]=D,C[U++]=G,C[U++]=G,C[U++]=I}}else{m=g.version;for(let x=0,M=0;x<y;x+=3){let U=x+0,I=x+1,D=x+2;C[M++]=U,C[M++]=I,C[M++]=I,C[M++]=D,C[M++]=D,C[M++]=U}}b.version=m;let E=r.get(p);E&&e.remove(E),r.set(p,b)}function h(p){let v=r.get(p);if(v){let g=p.index;g!==null&&v.version<g.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let v=s[p].deref();v!==void 0&&c(v)}}return{get:l,update:u,getWireframeAttribute:h,dispose:f}}function US(i,e,t){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function c(d,h){i.drawElements(n,h,r,d*o),t.update(h,n,1)}function l(d,h,f){f!==0&&(i.drawElementsInstanced(n,h,r,d*o,f),t.update(h,n,f))}function u(d,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,h,0,r,d,0,f);let v=0;for(let g=0;g<f;g++)v+=h[g];t.update(v,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function FS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:lt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function OS(i,e,t){let n=new WeakMap,s=new tn;function r(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=n.get(a);if(h===void 0||h.count!==d){let U=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",U)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],A=0;f===!0&&(A=1),p===!0&&(A=2),v===!0&&(A=3);let b=a.attributes.position.count*A,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let E=new Float32Array(b*C*4*d),x=new Aa(E,b,C,d);x.type=Vi,x.needsUpdate=!0;let M=A*4;for(let I=0;I<d;I++){let D=g[I],G=m[I],H=y[I],P=b*C*4*I;for(let V=0;V<D.count;V++){let z=V*M;f===!0&&(s.fromBufferAttribute(D,V),E[P+z+0]=s.x,E[P+z+1]=s.y,E[P+z+2]=s.z,E[P+z+3]=0),p===!0&&(s.fromBufferAttribute(G,V),E[P+z+4]=s.x,E[P+z+5]=s.y,E[P+z+6]=s.z,E[P+z+7]=0),v===!0&&(s.fromBufferAttribute(H,V),E[P+z+8]=s.x,E[P+z+9]=s.y,E[P+z+10]=s.z,E[P+z+11]=H.itemSize===4?s.w:1)}}h={count:d,texture:x,size:new St(b,C)},n.set(a,h),a.addEventListener("dispose",U)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<l.length;v++)f+=l[v];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(i,"morphTargetBaseInfluence",p),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",h.texture,t),c.getUniforms().setValue(i,"morphTargetsTextureSize",h.size)}return{update:r}}function BS(i,e,t,n,s){let r=new WeakMap;function o(l){let u=s.render.frame,d=l.geometry,h=e.get(l,d);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==u&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,u))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return h}function a(){r=new WeakMap}function c(l){let u=l.target;u.removeEventListener("dispose",c),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var kS={[Fd]:"LINEAR_TONE_MAPPING",[Od]:"REINHARD_TONE_MAPPING",[Bd]:"CINEON_TONE_MAPPING",[kd]:"ACES_FILMIC_TONE_MAPPING",[Gd]:"AGX_TONE_MAPPING",[Vd]:"NEUTRAL_TONE_MAPPING",[zd]:"CUSTOM_TONE_MAPPING"};function zS(i,e,t,n,s,r){let o=new _i(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,u=new vi;u.setAttribute("position",new en([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new en([0,2,0,0,2,0],2));let d=new bc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new Nn(u,d),f=new Ha(-1,1,1,-1,0,1),p=null,v=null,g=!1,m,y=null,A=[],b=!1;this.setSize=function(C,E){o.setSize(C,E),a!==null&&a.setSize(C,E),c!==null&&c.setSize(C,E);for(let x=0;x<A.length;x++){let M=A[x];M.setSize&&M.setSize(C,E)}},this.setEffects=function(C){A=C,b=A.length>0&&A[0].isRenderPass===!0;let E=o.width,x=o.height;A.length>0&&a===null&&(a=new _i(E,x,{type:Hi,depthBuffer:!1,stencilBuffer:!1}),c=new _i(E,x,{type:Hi,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&A.some(U=>U.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&l===null&&(l=new Ss(E,x),r===!0&&(l.format=Ts,l.type=Nr)),o.dispose(),o.depthTexture=M?l:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let U=0;U<A.length;U++){let I=A[U];I.setSize&&I.setSize(E,x),M&&I.needsDepthTexture===!0&&I.setDepthTexture&&I.setDepthTexture(l)}},this.begin=function(C,E){if(g||C.toneMapping===os&&A.length===0)return!1;if(y=E,E!==null){let x=E.width,M=E.height;(o.width!==x||o.height!==M)&&this.setSize(x,M)}return b===!1&&C.setRenderTarget(o),m=C.toneMapping,C.toneMapping=os,!0},this.hasRenderPass=function(){return b},this.end=function(C,E){C.toneMapping=m,g=!0;let x=o,M=a;for(let U=0;U<A.length;U++){let I=A[U];I.enabled!==!1&&(I.render(C,M,x,E),I.needsSwap!==!1&&(x=M,M=M===a?c:a))}if(p!==C.outputColorSpace||v!==C.toneMapping){p=C.outputColorSpace,v=C.toneMapping,d.defines={},Et.getTransfer(p)===Ut&&(d.defines.SRGB_TRANSFER="");let U=kS[v];U&&(d.defines[U]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(y),C.render(h,f),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),u.dispose(),d.dispose()}}var B0=new jn,k0=new Ss(1,1),z0=new Na(1),G0=new Aa,V0=new xc,H0=new La,x0=[],_0=[],v0=new Float32Array(16),y0=new Float32Array(9),b0=new Float32Array(4);function zo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=x0[s];if(r===void 0&&(r=new Float32Array(s),x0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function Mn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function Sn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Au(i,e){let t=_0[e];t===void 0&&(t=new Int32Array(e),_0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function GS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function VS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2fv(this.addr,e),Sn(t,e)}}function HS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Mn(t,e))return;i.uniform3fv(this.addr,e),Sn(t,e)}}function WS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4fv(this.addr,e),Sn(t,e)}}function XS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),Sn(t,e)}else{if(Mn(t,n))return;b0.set(n),i.uniformMatrix2fv(this.addr,!1,b0),Sn(t,n)}}function qS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),Sn(t,e)}else{if(Mn(t,n))return;y0.set(n),i.uniformMatrix3fv(this.addr,!1,y0),Sn(t,n)}}function YS(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(Mn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),Sn(t,e)}else{if(Mn(t,n))return;v0.set(n),i.uniformMatrix4fv(this.addr,!1,v0),Sn(t,n)}}function $S(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function ZS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2iv(this.addr,e),Sn(t,e)}}function JS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;i.uniform3iv(this.addr,e),Sn(t,e)}}function KS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4iv(this.addr,e),Sn(t,e)}}function jS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function QS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Mn(t,e))return;i.uniform2uiv(this.addr,e),Sn(t,e)}}function ew(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Mn(t,e))return;i.uniform3uiv(this.addr,e),Sn(t,e)}}function tw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Mn(t,e))return;i.uniform4uiv(this.addr,e),Sn(t,e)}}function Ru(i){return i.version===0&&(i.compareFunction=Qd,i.needsUpdate=!0),i}function nw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Ru(k0):r=B0,t.setTexture2D(e||r,s)}function iw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||V0,s)}function sw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Ru(z0):r=H0,t.setTextureCube(e||r,s)}function rw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||G0,s)}function ow(i){switch(i){case 5126:return GS;case 35664:return VS;case 35665:return HS;case 35666:return WS;case 35674:return XS;case 35675:return qS;case 35676:return YS;case 5124:case 35670:return $S;case 35667:case 35671:return ZS;case 35668:case 35672:return JS;case 35669:case 35673:return KS;case 5125:return jS;case 36294:return QS;case 36295:return ew;case 36296:return tw;case 35678:case 36198:case 36298:case 36306:case 35682:return nw;case 35679:case 36299:case 36307:return iw;case 35680:case 36300:case 36308:case 36293:return sw;case 36289:case 36303:case 36311:case 36292:return rw}}function aw(i,e){i.uniform1fv(this.addr,e)}function lw(i,e){let t=zo(e,this.size,2);i.uniform2fv(this.addr,t)}function cw(i,e){let t=zo(e,this.size,3);i.uniform3fv(this.addr,t)}function uw(i,e){let t=zo(e,this.size,4);i.uniform4fv(this.addr,t)}function hw(i,e){let t=zo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function dw(i,e){let t=zo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function fw(i,e){let t=zo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function pw(i,e){i.uniform1iv(this.addr,e)}function mw(i,e){i.uniform2iv(this.addr,e)}function gw(i,e){i.uniform3iv(this.addr,e)}function xw(i,e){i.uniform4iv(this.addr,e)}function _w(i,e){i.uniform1uiv(this.addr,e)}function vw(i,e){i.uniform2uiv(this.addr,e)}function yw(i,e){i.uniform3uiv(this.addr,e)}function bw(i,e){i.uniform4uiv(this.addr,e)}function Mw(i,e,t){let n=this.cache,s=e.length,r=Au(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Ru(k0):o=B0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Sw(i,e,t){let n=this.cache,s=e.length,r=Au(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||V0,r[o])}function ww(i,e,t){let n=this.cache,s=e.length,r=Au(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Ru(z0):o=H0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Tw(i,e,t){let n=this.cache,s=e.length,r=Au(t,s);Mn(n,r)||(i.uniform1iv(this.addr,r),Sn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||G0,r[o])}function Ew(i){switch(i){case 5126:return aw;case 35664:return lw;case 35665:return cw;case 35666:return uw;case 35674:return hw;case 35675:return dw;case 35676:return fw;case 5124:case 35670:return pw;case 35667:case 35671:return mw;case 35668:case 35672:return gw;case 35669:case 35673:return xw;case 5125:return _w;case 36294:return vw;case 36295:return yw;case 36296:return bw;case 35678:case 36198:case 36298:case 36306:case 35682:return Mw;case 35679:case 36299:case 36307:return Sw;case 35680:case 36300:case 36308:case 36293:return ww;case 36289:case 36303:case 36311:case 36292:return Tw}}var uf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=ow(t.type)}},hf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Ew(t.type)}},df=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},lf=/(\w+)(\])?(\[|\.)?/g;function M0(i,e){i.seq.push(e),i.map[e.id]=e}function Aw(i,e,t){let n=i.name,s=n.length;for(lf.lastIndex=0;;){let r=lf.exec(n),o=lf.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){M0(t,l===void 0?new uf(a,i,e):new hf(a,i,e));break}else{let d=t.map[a];d===void 0&&(d=new df(a),M0(t,d)),t=d}}}var ko=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),c=e.getUniformLocation(t,a.name);Aw(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(e,c.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function S0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var Rw=37297,Cw=0;function Pw(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var w0=new dt;function Iw(i){Et._getMatrix(w0,Et.workingColorSpace,i);let e=`mat3( ${w0.elements.map(t=>t.toFixed(4))} )`;switch(Et.getTransfer(i)){case Ta:return[e,"LinearTransferOETF"];case Ut:return[e,"sRGBTransferOETF"];default:return ot("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function T0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Pw(i.getShaderSource(e),a)}else return r}function Lw(i,e){let t=Iw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Dw={[Fd]:"Linear",[Od]:"Reinhard",[Bd]:"Cineon",[kd]:"ACESFilmic",[Gd]:"AgX",[Vd]:"Neutral",[zd]:"Custom"};function Nw(i,e){let t=Dw[e];return t===void 0?(ot("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var wu=new ee;function Uw(){Et.getLuminanceCoefficients(wu);let i=wu.x.toFixed(4),e=wu.y.toFixed(4),t=wu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Fw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(tl).join(`
`)}function Ow(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function Bw(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function tl(i){return i!==""}function E0(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function A0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var kw=/^[ \t]*#include +<([\w\d./]+)>/gm;function ff(i){return i.replace(kw,zw)}function zw(i,e){let t=xt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return ff(t)}var Gw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function R0(i){return i.replace(Gw,Vw)}function Vw(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function C0(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var Hw={[Xa]:"SHADOWMAP_TYPE_PCF",[Uo]:"SHADOWMAP_TYPE_VSM"};function Ww(i){return Hw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Xw={[Oo]:"ENVMAP_MODE_REFRACTION"};function qw(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":Xw[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Yw={[Fc]:"ENVMAP_BLENDING_MULTIPLY",[qg]:"ENVMAP_BLENDING_MIX",[Yg]:"ENVMAP_BLENDING_ADD"};function $w(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":Yw[i.combine]||"ENVMAP_BLENDING_NONE"}function Zw(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,c=Ww(t),l=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=qw(t),d=$w(t),h=Fw(t),f=Ow(r),p=s.createProgram(),v,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(tl).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(tl).join(`
`),g.length>0&&(g+=`
`)):(v=[C0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(tl).join(`
`),g=[C0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==os?"#define TONE_MAPPING":"",t.toneMapping!==os?xt.tonemapping_pars_fragment:"",t.toneMapping!==os?Nw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",xt.colorspace_pars_fragment,Lw("linearToOutputTexel",t.outputColorSpace),Uw(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(tl).join(`
`)),o=ff(o),o=E0(o,t),o=A0(o,t),a=ff(a),a=E0(a,t),a=A0(a,t),o=R0(o),a=R0(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,v=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===ef?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===ef?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=m+v+o,A=m+g+a,b=S0(s,s.VERTEX_SHADER,y),C=S0(s,s.FRAGMENT_SHADER,A);s.attachShader(p,b),s.attachShader(p,C),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(I){if(i.debug.checkShaderErrors){let D=s.getProgramInfoLog(p)||"",G=s.getShaderInfoLog(b)||"",H=s.getShaderInfoLog(C)||"",P=D.trim(),V=G.trim(),z=H.trim(),N=!0,re=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(N=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,b,C);else{let q=T0(s,b,"vertex"),$=T0(s,C,"fragment");lt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+I.name+`
Material Type: `+I.type+`

Program Info Log: `+P+`
`+q+`
`+$)}else P!==""?ot("WebGLProgram: Program Info Log:",P):(V===""||z==="")&&(re=!1);re&&(I.diagnostics={runnable:N,programLog:P,vertexShader:{log:V,prefix:v},fragmentShader:{log:z,prefix:g}})}s.deleteShader(b),s.deleteShader(C),x=new ko(s,p),M=Bw(s,p)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let M;this.getAttributes=function(){return M===void 0&&E(this),M};let U=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return U===!1&&(U=s.getProgramParameter(p,Rw)),U},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Cw++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=C,this}var Jw=0,pf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new mf(e),t.set(e,n)),n}},mf=class{constructor(e){this.id=Jw++,this.code=e,this.usedTimes=0}};function Kw(i){return i===ar||i===Ka||i===ja}function jw(i,e,t,n,s,r){let o=new Ra,a=new pf,c=new Set,l=[],u=new Map,d=n.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return c.add(x),x===0?"uv":`uv${x}`}function p(x,M,U,I,D,G){let H=I.fog,P=D.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?I.environment:null,z=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,N=e.get(x.envMap||V,z),re=h[x.type],q=n.precision;x.precision!==null&&(q=n.getMaxPrecision(x.precision),q!==x.precision&&ot("WebGLProgram.getParameters:",x.precision,"not supported, using",q,"instead."));let $=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,te=$!==void 0?$.length:0,ue=0;P.morphAttributes.position!==void 0&&(ue=1),P.morphAttributes.normal!==void 0&&(ue=2),P.morphAttributes.color!==void 0&&(ue=3);let de,K,xe,be;if(re){let O=ls[re];de=O.vertexShader,K=O.fragmentShader}else{de=x.vertexShader,K=x.fragmentShader;let O=a.getVertexShaderStage(x),ie=a.getFragmentShaderStage(x);a.update(x,O,ie),xe=O.id,be=ie.id}let Pe=i.getRenderTarget(),Ee=i.state.buffers.depth.getReversed(),Ve=D.isInstancedMesh===!0,Qe=D.isBatchedMesh===!0,Ge=!!x.map,ct=!!x.matcap,ft=!!N,tt=ft&&N.isPMREMTexture===!0,ye=!!x.aoMap,me=!!x.lightMap,Ne=!!x.bumpMap&&x.wireframe===!1,qe=!!x.normalMap,nt=!!x.displacementMap,ut=!!x.emissiveMap,Jt=!!x.metalnessMap,Pt=!!x.roughnessMap,kt=x.anisotropy>0,B=x.clearcoat>0,De=x.diffuseRoughness>0,et=x.dispersion>0,ht=x.retroreflectivity>0,we=x.iridescence>0,It=x.sheen>0,Ye=x.transmission>0,Ke=kt&&!!x.anisotropyMap,R=B&&!!x.clearcoatMap,S=B&&!!x.clearcoatNormalMap,Y=B&&!!x.clearcoatRoughnessMap,he=De&&!!x.diffuseRoughnessMap,ce=we&&!!x.iridescenceMap,Te=we&&!!x.iridescenceThicknessMap,Me=It&&!!x.sheenColorMap,se=It&&!!x.sheenRoughnessMap,oe=!!x.specularMap,_e=!!x.specularColorMap,k=!!x.specularIntensityMap,le=Ye&&!!x.transmissionMap,ae=Ye&&!!x.thicknessMap,Re=!!x.gradientMap,Se=!!x.alphaMap,Ae=x.alphaTest>0,Je=!!x.alphaHash,it=!!x.extensions,pe=os;x.toneMapped&&(Pe===null||Pe.isXRRenderTarget===!0)&&(pe=i.toneMapping);let He=tt?N.isCompressedCubeTexture?N.image[0].mipmaps:N.mipmaps:null,st={shaderID:re,shaderType:x.type,shaderName:x.name,vertexShader:de,fragmentShader:K,defines:x.defines,customVertexShaderID:xe,customFragmentShaderID:be,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:q,batching:Qe,batchingColor:Qe&&D._colorsTexture!==null,instancing:Ve,instancingColor:Ve&&D.instanceColor!==null,instancingMorph:Ve&&D.morphTexture!==null,outputColorSpace:Pe===null?i.outputColorSpace:Pe.isXRRenderTarget===!0?Pe.texture.colorSpace:Et.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ge,matcap:ct,envMap:ft,envMapMode:ft&&N.mapping,envMapPMREM:tt,envMapMaxLod:tt?He.length-1:null,envMapSize:tt?He[0].width:null,aoMap:ye,lightMap:me,bumpMap:Ne,normalMap:qe,displacementMap:nt,emissiveMap:ut,normalMapObjectSpace:qe&&x.normalMapType===Jg,normalMapTangentSpace:qe&&x.normalMapType===Mu,packedNormalMap:qe&&x.normalMapType===Mu&&Kw(x.normalMap.format),metalnessMap:Jt,roughnessMap:Pt,anisotropy:kt,anisotropyMap:Ke,clearcoat:B,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:Y,diffuseRoughness:De,diffuseRoughnessMap:he,dispersion:et,retroreflection:ht,iridescence:we,iridescenceMap:ce,iridescenceThicknessMap:Te,sheen:It,sheenColorMap:Me,sheenRoughnessMap:se,specularMap:oe,specularColorMap:_e,specularIntensityMap:k,transmission:Ye,transmissionMap:le,thicknessMap:ae,gradientMap:Re,opaque:x.transparent===!1&&x.blending===Fo&&x.alphaToCoverage===!1,alphaMap:Se,alphaTest:Ae,alphaHash:Je,combine:x.combine,mapUv:Ge&&f(x.map.channel),aoMapUv:ye&&f(x.aoMap.channel),lightMapUv:me&&f(x.lightMap.channel),bumpMapUv:Ne&&f(x.bumpMap.channel),normalMapUv:qe&&f(x.normalMap.channel),displacementMapUv:nt&&f(x.displacementMap.channel),emissiveMapUv:ut&&f(x.emissiveMap.channel),metalnessMapUv:Jt&&f(x.metalnessMap.channel),roughnessMapUv:Pt&&f(x.roughnessMap.channel),anisotropyMapUv:Ke&&f(x.anisotropyMap.channel),clearcoatMapUv:R&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Y&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:he&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:ce&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:Te&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:Me&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:se&&f(x.sheenRoughnessMap.channel),specularMapUv:oe&&f(x.specularMap.channel),specularColorMapUv:_e&&f(x.specularColorMap.channel),specularIntensityMapUv:k&&f(x.specularIntensityMap.channel),transmissionMapUv:le&&f(x.transmissionMap.channel),thicknessMapUv:ae&&f(x.thicknessMap.channel),alphaMapUv:Se&&f(x.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(qe||kt),vertexNormals:!!P.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!P.attributes.uv&&(Ge||Se),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||P.attributes.normal===void 0&&qe===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:Ee,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ue,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:G.filter(O=>O.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&U.length>0,shadowMapType:i.shadowMap.type,toneMapping:pe,decodeVideoTexture:Ge&&x.map.isVideoTexture===!0&&Et.getTransfer(x.map.colorSpace)===Ut,decodeVideoTextureEmissive:ut&&x.emissiveMap.isVideoTexture===!0&&Et.getTransfer(x.emissiveMap.colorSpace)===Ut,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Ci,flipSided:x.side===Qn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:it&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(it&&x.extensions.multiDraw===!0||Qe)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return st.vertexUv1s=c.has(1),st.vertexUv2s=c.has(2),st.vertexUv3s=c.has(3),c.clear(),st}function v(x){let M=[];if(x.shaderID?M.push(x.shaderID):(M.push(x.customVertexShaderID),M.push(x.customFragmentShaderID)),x.defines!==void 0)for(let U in x.defines)M.push(U),M.push(x.defines[U]);return x.isRawShaderMaterial===!1&&(g(M,x),m(M,x),M.push(i.outputColorSpace)),M.push(x.customProgramCacheKey),M.join()}function g(x,M){x.push(M.precision),x.push(M.outputColorSpace),x.push(M.envMapMode),x.push(M.envMapPMREM),x.push(M.envMapMaxLod),x.push(M.envMapSize),x.push(M.mapUv),x.push(M.alphaMapUv),x.push(M.lightMapUv),x.push(M.aoMapUv),x.push(M.bumpMapUv),x.push(M.normalMapUv),x.push(M.displacementMapUv),x.push(M.emissiveMapUv),x.push(M.metalnessMapUv),x.push(M.roughnessMapUv),x.push(M.anisotropyMapUv),x.push(M.clearcoatMapUv),x.push(M.clearcoatNormalMapUv),x.push(M.clearcoatRoughnessMapUv),x.push(M.diffuseRoughnessMapUv),x.push(M.iridescenceMapUv),x.push(M.iridescenceThicknessMapUv),x.push(M.sheenColorMapUv),x.push(M.sheenRoughnessMapUv),x.push(M.specularMapUv),x.push(M.specularColorMapUv),x.push(M.specularIntensityMapUv),x.push(M.transmissionMapUv),x.push(M.thicknessMapUv),x.push(M.combine),x.push(M.fogExp2),x.push(M.sizeAttenuation),x.push(M.morphTargetsCount),x.push(M.numSunLights),x.push(M.numDirLights),x.push(M.numPointLights),x.push(M.numSpotLights),x.push(M.numSpotLightMaps),x.push(M.numHemiLights),x.push(M.numRectAreaLights),x.push(M.numSunLightShadows),x.push(M.numDirLightShadows),x.push(M.numPointLightShadows),x.push(M.numSpotLightShadows),x.push(M.numSpotLightShadowsWithMaps),x.push(M.numLightProbes),x.push(M.numLightProbeGrids),x.push(M.shadowMapType),x.push(M.toneMapping),x.push(M.numClippingPlanes),x.push(M.numClipIntersection),x.push(M.depthPacking)}function m(x,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let M=h[x.type],U;if(M){let I=ls[M];U=u0.clone(I.uniforms)}else U=x.uniforms;return U}function A(x,M){let U=u.get(M);return U!==void 0?++U.usedTimes:(U=new Zw(i,M,x,s),l.push(U),u.set(M,U)),U}function b(x){if(--x.usedTimes===0){let M=l.indexOf(x);l[M]=l[l.length-1],l.pop(),u.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:y,acquireProgram:A,releaseProgram:b,releaseShaderCache:C,programs:l,dispose:E}}function Qw(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function e1(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function P0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function I0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,p,v,g,m){let y=i[e];return y===void 0?(y={id:h.id,object:h,geometry:f,material:p,materialVariant:o(h),groupOrder:v,renderOrder:h.renderOrder,z:g,group:m},i[e]=y):(y.id=h.id,y.object=h,y.geometry=f,y.material=p,y.materialVariant=o(h),y.groupOrder=v,y.renderOrder=h.renderOrder,y.z=g,y.group=m),e++,y}function c(h,f,p,v,g,m,y){y.reversedDepth===!0&&(g=-g);let A=a(h,f,p,v,g,m);p.transmission>0?n.push(A):p.transparent===!0?s.push(A):t.push(A)}function l(h,f,p,v,g,m){let y=a(h,f,p,v,g,m);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function u(h,f){t.length>1&&t.sort(h||e1),n.length>1&&n.sort(f||P0),s.length>1&&s.sort(f||P0)}function d(){for(let h=e,f=i.length;h<f;h++){let p=i[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:d,sort:u}}function t1(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new I0,i.set(n,[o])):s>=r.length?(o=new I0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function n1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new ee,color:new vt};break;case"SpotLight":t={position:new ee,direction:new ee,color:new vt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new ee,color:new vt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new ee,skyColor:new vt,groundColor:new vt};break;case"RectAreaLight":t={color:new vt,position:new ee,halfWidth:new ee,halfHeight:new ee};break}return i[e.id]=t,t}}}function i1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new St};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new St};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new St,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var s1=0;function r1(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function o1(i){let e=new n1,t=i1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new ee);let s=new ee,r=new Qt,o=new Qt;function a(l){let u=0,d=0,h=0;for(let G=0;G<9;G++)n.probe[G].set(0,0,0);let f=0,p=0,v=0,g=0,m=0,y=0,A=0,b=0,C=0,E=0,x=0,M=0,U=0,I=0;l.sort(r1);for(let G=0,H=l.length;G<H;G++){let P=l[G],V=P.color,z=P.intensity,N=P.distance,re=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===ar?re=P.shadow.map.texture:re=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)u+=V.r*z,d+=V.g*z,h+=V.b*z;else if(P.isLightProbe){for(let q=0;q<9;q++)n.probe[q].addScaledVector(P.sh.coefficients[q],z);I++}else if(P.isSunLight){let q=e.get(P);if(q.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let $=P.shadow,te=t.get(P);te.shadowIntensity=$.intensity,te.shadowBias=$.bias,te.shadowNormalBias=$.normalBias,te.shadowRadius=$.radius,te.shadowMapSize.copy($.mapSize).multiply($.getFrameExtents()),n.sunShadow[p]=te,n.sunShadowMap[p]=re;let ue=$.getViewportCount();for(let de=0;de<ue;de++)n.sunShadowMatrix[v+de]=$.getMatrix(de),n.sunShadowCascade[v+de]=$._cascadeData[de];v+=ue,p++}n.sun[f]=q,f++}else if(P.isDirectionalLight){let q=e.get(P);if(q.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let $=P.shadow,te=t.get(P);te.shadowIntensity=$.intensity,te.shadowBias=$.bias,te.shadowNormalBias=$.normalBias,te.shadowRadius=$.radius,te.shadowMapSize=$.mapSize,n.directionalShadow[g]=te,n.directionalShadowMap[g]=re,n.directionalShadowMatrix[g]=P.shadow.matrix,C++}n.directional[g]=q,g++}else if(P.isSpotLight){let q=e.get(P);q.position.setFromMatrixPosition(P.matrixWorld),q.color.copy(V).multiplyScalar(z),q.distance=N,q.coneCos=Math.cos(P.angle),q.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),q.decay=P.decay,n.spot[y]=q;let $=P.shadow;if(P.map&&(n.spotLightMap[M]=P.map,M++,$.updateMatrices(P),P.castShadow&&U++),n.spotLightMatrix[y]=$.matrix,P.castShadow){let te=t.get(P);te.shadowIntensity=$.intensity,te.shadowBias=$.bias,te.shadowNormalBias=$.normalBias,te.shadowRadius=$.radius,te.shadowMapSize=$.mapSize,n.spotShadow[y]=te,n.spotShadowMap[y]=re,x++}y++}else if(P.isRectAreaLight){let q=e.get(P);q.color.copy(V).multiplyScalar(z),q.halfWidth.set(P.width*.5,0,0),q.halfHeight.set(0,P.height*.5,0),n.rectArea[A]=q,A++}else if(P.isPointLight){let q=e.get(P);if(q.color.copy(P.color).multiplyScalar(P.intensity),q.distance=P.distance,q.decay=P.decay,P.castShadow){let $=P.shadow,te=t.get(P);te.shadowIntensity=$.intensity,te.shadowBias=$.bias,te.shadowNormalBias=$.normalBias,te.shadowRadius=$.radius,te.shadowMapSize=$.mapSize,te.shadowCameraNear=$.camera.near,te.shadowCameraFar=$.camera.far,n.pointShadow[m]=te,n.pointShadowMap[m]=re,n.pointShadowMatrix[m]=P.shadow.matrix,E++}n.point[m]=q,m++}else if(P.isHemisphereLight){let q=e.get(P);q.skyColor.copy(P.color).multiplyScalar(z),q.groundColor.copy(P.groundColor).multiplyScalar(z),n.hemi[b]=q,b++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Oe.LTC_FLOAT_1,n.rectAreaLTC2=Oe.LTC_FLOAT_2):(n.rectAreaLTC1=Oe.LTC_HALF_1,n.rectAreaLTC2=Oe.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=d,n.ambient[2]=h;let D=n.hash;(D.sunLength!==f||D.directionalLength!==g||D.pointLength!==m||D.spotLength!==y||D.rectAreaLength!==A||D.hemiLength!==b||D.numSunShadows!==p||D.numDirectionalShadows!==C||D.numPointShadows!==E||D.numSpotShadows!==x||D.numSpotMaps!==M||D.numLightProbes!==I)&&(n.sun.length=f,n.directional.length=g,n.spot.length=y,n.rectArea.length=A,n.point.length=m,n.hemi.length=b,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=v,n.sunShadowCascade.length=v,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+M-U,n.spotLightMap.length=M,n.numSpotLightShadowsWithMaps=U,n.numLightProbes=I,D.sunLength=f,D.directionalLength=g,D.pointLength=m,D.spotLength=y,D.rectAreaLength=A,D.hemiLength=b,D.numSunShadows=p,D.numDirectionalShadows=C,D.numPointShadows=E,D.numSpotShadows=x,D.numSpotMaps=M,D.numLightProbes=I,n.version=s1++)}function c(l,u){let d=0,h=0,f=0,p=0,v=0,g=0,m=u.matrixWorldInverse;for(let y=0,A=l.length;y<A;y++){let b=l[y];if(b.isSunLight){let C=n.sun[d];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(m),d++}else if(b.isDirectionalLight){let C=n.directional[h];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),h++}else if(b.isSpotLight){let C=n.spot[p];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let C=n.rectArea[v];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),v++}else if(b.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(m),f++}else if(b.isHemisphereLight){let C=n.hemi[g];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(m),g++}}}return{setup:a,setupView:c,state:n}}function L0(i){let e=new o1(i),t=[],n=[],s=[];function r(d){u.camera=d,t.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){n.push(d)}function c(){e.setup(t),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function l(d){e.setupView(t,d)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function a1(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new L0(i),e.set(s,[a])):r>=o.length?(a=new L0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var l1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,c1=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,u1=[new ee(1,0,0),new ee(-1,0,0),new ee(0,1,0),new ee(0,-1,0),new ee(0,0,1),new ee(0,0,-1)],h1=[new ee(0,-1,0),new ee(0,-1,0),new ee(0,0,1),new ee(0,0,-1),new ee(0,-1,0),new ee(0,-1,0)],D0=new Qt,el=new ee,cf=new ee;function d1(i,e,t){let n=new tr,s=new St,r=new St,o=new tn,a=new Mc,c=new Sc,l={},u=t.maxTextureSize,d={[or]:Qn,[Qn]:or,[Ci]:Ci},h=new rs({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new St},radius:{value:4}},vertexShader:l1,fragmentShader:c1}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let p=new vi;p.setAttribute("position",new Ri(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Nn(p,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xa;let m=this.type;this.render=function(E,x,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||E.length===0)return;this.type===Ag&&(ot("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xa);let U=i.getRenderTarget(),I=i.getActiveCubeFace(),D=i.getActiveMipmapLevel(),G=i.state;G.setBlending(Ir),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let H=m!==this.type;H&&x.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(V=>V.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,V=E.length;P<V;P++){let z=E[P],N=z.shadow;if(N===void 0){ot("WebGLShadowMap:",z,"has no shadow.");continue}if(N.autoUpdate===!1&&N.needsUpdate===!1)continue;s.copy(N.mapSize);let re=N.getFrameExtents();s.multiply(re),r.copy(N.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/re.x),s.x=r.x*re.x,N.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/re.y),s.y=r.y*re.y,N.mapSize.y=r.y));let q=i.state.buffers.depth.getReversed();if(N.camera._reversedDepth=q,N.map===null||H===!0){if(N.map!==null&&(N.map.depthTexture!==null&&(N.map.depthTexture.dispose(),N.map.depthTexture=null),N.map.dispose()),this.type===Uo){if(z.isPointLight){ot("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}N.map=new _i(s.x,s.y,{format:ar,type:Hi,minFilter:Kn,magFilter:Kn,generateMipmaps:!1}),N.map.texture.name=z.name+".shadowMap",N.map.depthTexture=new Ss(s.x,s.y,Vi),N.map.depthTexture.name=z.name+".shadowMapDepth",N.map.depthTexture.format=bs,N.map.depthTexture.compareFunction=null,N.map.depthTexture.minFilter=Dn,N.map.depthTexture.magFilter=Dn}else z.isPointLight?(N.map=new nl(s.x),N.map.depthTexture=new Na(s.x,Gi)):(N.map=new _i(s.x,s.y),N.map.depthTexture=new Ss(s.x,s.y,Gi)),N.map.depthTexture.name=z.name+".shadowMap",N.map.depthTexture.format=bs,this.type===Xa?(N.map.depthTexture.compareFunction=q?jd:Kd,N.map.depthTexture.minFilter=Kn,N.map.depthTexture.magFilter=Kn):(N.map.depthTexture.compareFunction=null,N.map.depthTexture.minFilter=Dn,N.map.depthTexture.magFilter=Dn);N.camera.updateProjectionMatrix()}N.map.isWebGLCubeRenderTarget!==!0&&(N.map.width!==s.x||N.map.height!==s.y)&&N.map.setSize(s.x,s.y);let $=N.map.isWebGLCubeRenderTarget?6:N.getViewportCount();z.isPointLight!==!0&&N.updateMatrices(z,M);let te=(N.camera.layers.mask&4294967294)!==0?N.camera.layers:M.layers;for(let ue=0;ue<$;ue++){let de=N.getCamera(ue);if(z.isPointLight){let K=N.camera,xe=N.matrix,be=z.distance||K.far;be!==K.far&&(K.far=be,K.updateProjectionMatrix()),el.setFromMatrixPosition(z.matrixWorld),K.position.copy(el),cf.copy(K.position),cf.add(u1[ue]),K.up.copy(h1[ue]),K.lookAt(cf),K.updateMatrixWorld(),xe.makeTranslation(-el.x,-el.y,-el.z),D0.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),N._frustum.setFromProjectionMatrix(D0,K.coordinateSystem,K.reversedDepth)}if(N.map.isWebGLCubeRenderTarget)i.setRenderTarget(N.map,ue),i.clear();else{ue===0&&(i.setRenderTarget(N.map),i.clear());let K=N.getViewport(ue);o.set(r.x*K.x,r.y*K.y,r.x*K.z,r.y*K.w),G.viewport(o)}n=N.getFrustum(ue),b(x,M,de,z,te,this.type)}N.isPointLightShadow!==!0&&this.type===Uo&&y(N,M),N.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(U,I,D)};function y(E,x){let M=e.update(v);h.defines.VSM_SAMPLES!==E.blurSamples&&(h.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new _i(s.x,s.y,{format:ar,type:Hi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),h.uniforms.shadow_pass.value=E.map.depthTexture,h.uniforms.resolution.value.set(E.map.width,E.map.height),h.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,M,h,v,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,M,f,v,null)}function A(E,x,M,U){let I=null,D=M.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)I=D;else if(I=M.isPointLight===!0?c:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let G=I.uuid,H=x.uuid,P=l[G];P===void 0&&(P={},l[G]=P);let V=P[H];V===void 0&&(V=I.clone(),P[H]=V,x.addEventListener("dispose",C)),I=V}if(I.visible=x.visible,I.wireframe=x.wireframe,U===Uo?I.side=x.shadowSide!==null?x.shadowSide:x.side:I.side=x.shadowSide!==null?x.shadowSide:d[x.side],I.alphaMap=x.alphaMap,I.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,I.map=x.map,I.clipShadows=x.clipShadows,I.clippingPlanes=x.clippingPlanes,I.clipIntersection=x.clipIntersection,I.displacementMap=x.displacementMap,I.displacementScale=x.displacementScale,I.displacementBias=x.displacementBias,I.wireframeLinewidth=x.wireframeLinewidth,I.linewidth=x.linewidth,M.isPointLight===!0&&I.isMeshDistanceMaterial===!0){let G=i.properties.get(I);G.light=M}return I}function b(E,x,M,U,I,D){if(E.visible===!1)return;if(E.layers.test(I)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===Uo)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,E.matrixWorld);let P=e.update(E),V=E.material;if(Array.isArray(V)){let z=P.groups;for(let N=0,re=z.length;N<re;N++){let q=z[N],$=V[q.materialIndex];if($&&$.visible){let te=A(E,$,U,D);E.onBeforeShadow(i,E,x,M,P,te,q),i.renderBufferDirect(M,null,P,te,E,q),E.onAfterShadow(i,E,x,M,P,te,q)}}}else if(V.visible){let z=A(E,V,U,D);E.onBeforeShadow(i,E,x,M,P,z,null),i.renderBufferDirect(M,null,P,z,E,null),E.onAfterShadow(i,E,x,M,P,z,null)}}let H=E.children;for(let P=0,V=H.length;P<V;P++)b(H[P],x,M,U,I,D)}function C(E){E.target.removeEventListener("dispose",C);for(let M in l){let U=l[M],I=E.target.uuid;I in U&&(U[I].dispose(),delete U[I])}}}function f1(i,e){function t(){let k=!1,le=new tn,ae=null,Re=new tn(0,0,0,0);return{setMask:function(Se){ae!==Se&&!k&&(i.colorMask(Se,Se,Se,Se),ae=Se)},setLocked:function(Se){k=Se},setClear:function(Se,Ae,Je,it,pe){pe===!0&&(Se*=it,Ae*=it,Je*=it),le.set(Se,Ae,Je,it),Re.equals(le)===!1&&(i.clearColor(Se,Ae,Je,it),Re.copy(le))},reset:function(){k=!1,ae=null,Re.set(-1,0,0,0)}}}function n(){let k=!1,le=!1,ae=null,Re=null,Se=null;return{setReversed:function(Ae){if(le!==Ae){let Je=e.get("EXT_clip_control");Ae?Je.clipControlEXT(Je.LOWER_LEFT_EXT,Je.ZERO_TO_ONE_EXT):Je.clipControlEXT(Je.LOWER_LEFT_EXT,Je.NEGATIVE_ONE_TO_ONE_EXT),le=Ae;let it=Se;Se=null,this.setClear(it)}},getReversed:function(){return le},setTest:function(Ae){Ae?Ee(i.DEPTH_TEST):Ve(i.DEPTH_TEST)},setMask:function(Ae){ae!==Ae&&!k&&(i.depthMask(Ae),ae=Ae)},setFunc:function(Ae){if(le&&(Ae=a0[Ae]),Re!==Ae){switch(Ae){case sc:i.depthFunc(i.NEVER);break;case rc:i.depthFunc(i.ALWAYS);break;case oc:i.depthFunc(i.LESS);break;case To:i.depthFunc(i.LEQUAL);break;case ac:i.depthFunc(i.EQUAL);break;case lc:i.depthFunc(i.GEQUAL);break;case cc:i.depthFunc(i.GREATER);break;case uc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Re=Ae}},setLocked:function(Ae){k=Ae},setClear:function(Ae){Se!==Ae&&(Se=Ae,le&&(Ae=1-Ae),i.clearDepth(Ae))},reset:function(){k=!1,ae=null,Re=null,Se=null,le=!1}}}function s(){let k=!1,le=null,ae=null,Re=null,Se=null,Ae=null,Je=null,it=null,pe=null;return{setTest:function(He){k||(He?Ee(i.STENCIL_TEST):Ve(i.STENCIL_TEST))},setMask:function(He){le!==He&&!k&&(i.stencilMask(He),le=He)},setFunc:function(He,st,O){(ae!==He||Re!==st||Se!==O)&&(i.stencilFunc(He,st,O),ae=He,Re=st,Se=O)},setOp:function(He,st,O){(Ae!==He||Je!==st||it!==O)&&(i.stencilOp(He,st,O),Ae=He,Je=st,it=O)},setLocked:function(He){k=He},setClear:function(He){pe!==He&&(i.clearStencil(He),pe=He)},reset:function(){k=!1,le=null,ae=null,Re=null,Se=null,Ae=null,Je=null,it=null,pe=null}}}let r=new t,o=new n,a=new s,c={},l=new WeakMap,u={},d={},h={},f=new WeakMap,p=[],v=null,g=!1,m=null,y=null,A=null,b=null,C=null,E=null,x=null,M=new vt(0,0,0),U=0,I=!1,D=null,G=null,H=null,P=null,V=null,z=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),N=!1,re=0,q=i.getParameter(i.VERSION);q.indexOf("WebGL")!==-1?(re=parseFloat(/^WebGL (\d)/.exec(q)[1]),N=re>=1):q.indexOf("OpenGL ES")!==-1&&(re=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),N=re>=2);let $=null,te={},ue=i.getParameter(i.SCISSOR_BOX),de=i.getParameter(i.VIEWPORT),K=new tn().fromArray(ue),xe=new tn().fromArray(de);function be(k,le,ae,Re){let Se=new Uint8Array(4),Ae=i.createTexture();i.bindTexture(k,Ae),i.texParameteri(k,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(k,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Je=0;Je<ae;Je++)k===i.TEXTURE_3D||k===i.TEXTURE_2D_ARRAY?i.texImage3D(le,0,i.RGBA,1,1,Re,0,i.RGBA,i.UNSIGNED_BYTE,Se):i.texImage2D(le+Je,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Se);return Ae}let Pe={};Pe[i.TEXTURE_2D]=be(i.TEXTURE_2D,i.TEXTURE_2D,1),Pe[i.TEXTURE_CUBE_MAP]=be(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pe[i.TEXTURE_2D_ARRAY]=be(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Pe[i.TEXTURE_3D]=be(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Ee(i.DEPTH_TEST),o.setFunc(To),Ne(!1),qe(Pd),Ee(i.CULL_FACE),ye(Ir);function Ee(k){u[k]!==!0&&(i.enable(k),u[k]=!0)}function Ve(k){u[k]!==!1&&(i.disable(k),u[k]=!1)}function Qe(k,le){return h[k]!==le?(i.bindFramebuffer(k,le),h[k]=le,k===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=le),k===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=le),!0):!1}function Ge(k,le){let ae=p,Re=!1;if(k){ae=f.get(le),ae===void 0&&(ae=[],f.set(le,ae));let Se=k.textures;if(ae.length!==Se.length||ae[0]!==i.COLOR_ATTACHMENT0){for(let Ae=0,Je=Se.length;Ae<Je;Ae++)ae[Ae]=i.COLOR_ATTACHMENT0+Ae;ae.length=Se.length,Re=!0}}else ae[0]!==i.BACK&&(ae[0]=i.BACK,Re=!0);Re&&i.drawBuffers(ae)}function ct(k){return v!==k?(i.useProgram(k),v=k,!0):!1}let ft={[Lr]:i.FUNC_ADD,[Cg]:i.FUNC_SUBTRACT,[Pg]:i.FUNC_REVERSE_SUBTRACT};ft[Ig]=i.MIN,ft[Lg]=i.MAX;let tt={[Dg]:i.ZERO,[Ng]:i.ONE,[Ug]:i.SRC_COLOR,[Nd]:i.SRC_ALPHA,[Gg]:i.SRC_ALPHA_SATURATE,[kg]:i.DST_COLOR,[Og]:i.DST_ALPHA,[Fg]:i.ONE_MINUS_SRC_COLOR,[Ud]:i.ONE_MINUS_SRC_ALPHA,[zg]:i.ONE_MINUS_DST_COLOR,[Bg]:i.ONE_MINUS_DST_ALPHA,[Vg]:i.CONSTANT_COLOR,[Hg]:i.ONE_MINUS_CONSTANT_COLOR,[Wg]:i.CONSTANT_ALPHA,[Xg]:i.ONE_MINUS_CONSTANT_ALPHA};function ye(k,le,ae,Re,Se,Ae,Je,it,pe,He){if(k===Ir){g===!0&&(Ve(i.BLEND),g=!1);return}if(g===!1&&(Ee(i.BLEND),g=!0),k!==Rg){if(k!==m||He!==I){if((y!==Lr||C!==Lr)&&(i.blendEquation(i.FUNC_ADD),y=Lr,C=Lr),He)switch(k){case Fo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Id:i.blendFunc(i.ONE,i.ONE);break;case Ld:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Dd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:lt("WebGLState: Invalid blending: ",k);break}else switch(k){case Fo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Id:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Ld:lt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Dd:lt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:lt("WebGLState: Invalid blending: ",k);break}A=null,b=null,E=null,x=null,M.set(0,0,0),U=0,m=k,I=He}return}Se=Se||le,Ae=Ae||ae,Je=Je||Re,(le!==y||Se!==C)&&(i.blendEquationSeparate(ft[le],ft[Se]),y=le,C=Se),(ae!==A||Re!==b||Ae!==E||Je!==x)&&(i.blendFuncSeparate(tt[ae],tt[Re],tt[Ae],tt[Je]),A=ae,b=Re,E=Ae,x=Je),(it.equals(M)===!1||pe!==U)&&(i.blendColor(it.r,it.g,it.b,pe),M.copy(it),U=pe),m=k,I=!1}function me(k,le){k.side===Ci?Ve(i.CULL_FACE):Ee(i.CULL_FACE);let ae=k.side===Qn;le&&(ae=!ae),Ne(ae),k.blending===Fo&&k.transparent===!1?ye(Ir):ye(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),r.setMask(k.colorWrite);let Re=k.stencilWrite;a.setTest(Re),Re&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),ut(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Ee(i.SAMPLE_ALPHA_TO_COVERAGE):Ve(i.SAMPLE_ALPHA_TO_COVERAGE)}function Ne(k){D!==k&&(k?i.frontFace(i.CW):i.frontFace(i.CCW),D=k)}function qe(k){k!==Tg?(Ee(i.CULL_FACE),k!==G&&(k===Pd?i.cullFace(i.BACK):k===Eg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ve(i.CULL_FACE),G=k}function nt(k){k!==H&&(N&&i.lineWidth(k),H=k)}function ut(k,le,ae){k?(Ee(i.POLYGON_OFFSET_FILL),(P!==le||V!==ae)&&(P=le,V=ae,o.getReversed()&&(le=-le,ae=-ae),i.polygonOffset(le,ae))):Ve(i.POLYGON_OFFSET_FILL)}function Jt(k){k?Ee(i.SCISSOR_TEST):Ve(i.SCISSOR_TEST)}function Pt(k){k===void 0&&(k=i.TEXTURE0+z-1),$!==k&&(i.activeTexture(k),$=k)}function kt(k,le,ae){ae===void 0&&($===null?ae=i.TEXTURE0+z-1:ae=$);let Re=te[ae];Re===void 0&&(Re={type:void 0,texture:void 0},te[ae]=Re),(Re.type!==k||Re.texture!==le)&&($!==ae&&(i.activeTexture(ae),$=ae),i.bindTexture(k,le||Pe[k]),Re.type=k,Re.texture=le)}function B(){let k=te[$];k!==void 0&&k.type!==void 0&&(i.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function De(){try{i.compressedTexImage2D(...arguments)}catch(k){lt("WebGLState:",k)}}function et(){try{i.compressedTexImage3D(...arguments)}catch(k){lt("WebGLState:",k)}}function ht(){try{i.texSubImage2D(...arguments)}catch(k){lt("WebGLState:",k)}}function we(){try{i.texSubImage3D(...arguments)}catch(k){lt("WebGLState:",k)}}function It(){try{i.compressedTexSubImage2D(...arguments)}catch(k){lt("WebGLState:",k)}}function Ye(){try{i.compressedTexSubImage3D(...arguments)}catch(k){lt("WebGLState:",k)}}function Ke(){try{i.texStorage2D(...arguments)}catch(k){lt("WebGLState:",k)}}function R(){try{i.texStorage3D(...arguments)}catch(k){lt("WebGLState:",k)}}function S(){try{i.texImage2D(...arguments)}catch(k){lt("WebGLState:",k)}}function Y(){try{i.texImage3D(...arguments)}catch(k){lt("WebGLState:",k)}}function he(k){return d[k]!==void 0?d[k]:i.getParameter(k)}function ce(k,le){d[k]!==le&&(i.pixelStorei(k,le),d[k]=le)}function Te(k){K.equals(k)===!1&&(i.scissor(k.x,k.y,k.z,k.w),K.copy(k))}function Me(k){xe.equals(k)===!1&&(i.viewport(k.x,k.y,k.z,k.w),xe.copy(k))}function se(k,le){let ae=l.get(le);ae===void 0&&(ae=new WeakMap,l.set(le,ae));let Re=ae.get(k);Re===void 0&&(Re=i.getUniformBlockIndex(le,k.name),i.uniformBlockBinding(le,Re,Re),ae.set(k,Re))}function oe(k,le,ae){let Se=l.get(le).get(k);c[Se]!==ae&&(i.bindBufferBase(i.UNIFORM_BUFFER,Se,ae),c[Se]=ae)}function _e(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},d={},$=null,te={},h={},c={},f=new WeakMap,p=[],v=null,g=!1,m=null,y=null,A=null,b=null,C=null,E=null,x=null,M=new vt(0,0,0),U=0,I=!1,D=null,G=null,H=null,P=null,V=null,K.set(0,0,i.canvas.width,i.canvas.height),xe.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Ee,disable:Ve,bindFramebuffer:Qe,drawBuffers:Ge,useProgram:ct,setBlending:ye,setMaterial:me,setFlipSided:Ne,setCullFace:qe,setLineWidth:nt,setPolygonOffset:ut,setScissorTest:Jt,activeTexture:Pt,bindTexture:kt,unbindTexture:B,compressedTexImage2D:De,compressedTexImage3D:et,texImage2D:S,texImage3D:Y,pixelStorei:ce,getParameter:he,updateUBOMapping:se,uniformBlockBinding:oe,texStorage2D:Ke,texStorage3D:R,texSubImage2D:ht,texSubImage3D:we,compressedTexSubImage2D:It,compressedTexSubImage3D:Ye,scissor:Te,viewport:Me,reset:_e}}function p1(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new St,u=new WeakMap,d=new Set,h,f=new WeakMap,p=new Set,v=new FinalizationRegistry(R=>p.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,S){return g?new OffscreenCanvas(R,S):Ea("canvas")}function y(R,S,Y){let he=1,ce=Ke(R);if((ce.width>Y||ce.height>Y)&&(he=Y/Math.max(ce.width,ce.height)),he<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let Te=Math.floor(he*ce.width),Me=Math.floor(he*ce.height);h===void 0&&(h=m(Te,Me));let se=S?m(Te,Me):h;return se.width=Te,se.height=Me,se.getContext("2d").drawImage(R,0,0,Te,Me),ot("WebGLRenderer: Texture has been resized from ("+ce.width+"x"+ce.height+") to ("+Te+"x"+Me+")."),se}else return"data"in R&&ot("WebGLRenderer: Image in DataTexture is too big ("+ce.width+"x"+ce.height+")."),R;return R}function A(R){return R.generateMipmaps}function b(R){i.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(R,S,Y,he,ce,Te=!1){if(R!==null){if(i[R]!==void 0)return i[R];ot("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let Me;he&&(Me=e.get("EXT_texture_norm16"),Me||ot("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let se=S;if(S===i.RED&&(Y===i.FLOAT&&(se=i.R32F),Y===i.HALF_FLOAT&&(se=i.R16F),Y===i.UNSIGNED_BYTE&&(se=i.R8),Y===i.UNSIGNED_SHORT&&Me&&(se=Me.R16_EXT),Y===i.SHORT&&Me&&(se=Me.R16_SNORM_EXT)),S===i.RED_INTEGER&&(Y===i.UNSIGNED_BYTE&&(se=i.R8UI),Y===i.UNSIGNED_SHORT&&(se=i.R16UI),Y===i.UNSIGNED_INT&&(se=i.R32UI),Y===i.BYTE&&(se=i.R8I),Y===i.SHORT&&(se=i.R16I),Y===i.INT&&(se=i.R32I)),S===i.RG&&(Y===i.FLOAT&&(se=i.RG32F),Y===i.HALF_FLOAT&&(se=i.RG16F),Y===i.UNSIGNED_BYTE&&(se=i.RG8),Y===i.UNSIGNED_SHORT&&Me&&(se=Me.RG16_EXT),Y===i.SHORT&&Me&&(se=Me.RG16_SNORM_EXT)),S===i.RG_INTEGER&&(Y===i.UNSIGNED_BYTE&&(se=i.RG8UI),Y===i.UNSIGNED_SHORT&&(se=i.RG16UI),Y===i.UNSIGNED_INT&&(se=i.RG32UI),Y===i.BYTE&&(se=i.RG8I),Y===i.SHORT&&(se=i.RG16I),Y===i.INT&&(se=i.RG32I)),S===i.RGB_INTEGER&&(Y===i.UNSIGNED_BYTE&&(se=i.RGB8UI),Y===i.UNSIGNED_SHORT&&(se=i.RGB16UI),Y===i.UNSIGNED_INT&&(se=i.RGB32UI),Y===i.BYTE&&(se=i.RGB8I),Y===i.SHORT&&(se=i.RGB16I),Y===i.INT&&(se=i.RGB32I)),S===i.RGBA_INTEGER&&(Y===i.UNSIGNED_BYTE&&(se=i.RGBA8UI),Y===i.UNSIGNED_SHORT&&(se=i.RGBA16UI),Y===i.UNSIGNED_INT&&(se=i.RGBA32UI),Y===i.BYTE&&(se=i.RGBA8I),Y===i.SHORT&&(se=i.RGBA16I),Y===i.INT&&(se=i.RGBA32I)),S===i.RGB&&(Y===i.UNSIGNED_SHORT&&Me&&(se=Me.RGB16_EXT),Y===i.SHORT&&Me&&(se=Me.RGB16_SNORM_EXT),Y===i.UNSIGNED_INT_5_9_9_9_REV&&(se=i.RGB9_E5),Y===i.UNSIGNED_INT_10F_11F_11F_REV&&(se=i.R11F_G11F_B10F)),S===i.RGBA){let oe=Te?Ta:Et.getTransfer(ce);Y===i.FLOAT&&(se=i.RGBA32F),Y===i.HALF_FLOAT&&(se=i.RGBA16F),Y===i.UNSIGNED_BYTE&&(se=oe===Ut?i.SRGB8_ALPHA8:i.RGBA8),Y===i.UNSIGNED_SHORT&&Me&&(se=Me.RGBA16_EXT),Y===i.SHORT&&Me&&(se=Me.RGBA16_SNORM_EXT),Y===i.UNSIGNED_SHORT_4_4_4_4&&(se=i.RGBA4),Y===i.UNSIGNED_SHORT_5_5_5_1&&(se=i.RGB5_A1)}return(se===i.R16F||se===i.R32F||se===i.RG16F||se===i.RG32F||se===i.RGBA16F||se===i.RGBA32F)&&e.get("EXT_color_buffer_float"),se}function x(R,S){let Y;return R?S===null||S===Gi||S===Nr?Y=i.DEPTH24_STENCIL8:S===Vi?Y=i.DEPTH32F_STENCIL8:S===Bo&&(Y=i.DEPTH24_STENCIL8,ot("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Gi||S===Nr?Y=i.DEPTH_COMPONENT24:S===Vi?Y=i.DEPTH_COMPONENT32F:S===Bo&&(Y=i.DEPTH_COMPONENT16),Y}function M(R,S){return A(R)===!0||R.isFramebufferTexture&&R.minFilter!==Dn&&R.minFilter!==Kn?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function U(R){let S=new WeakRef(R);n.get(R).__ref=S,p.add(S),v.register(R,S,S)}function I(R){let S=n.get(R).__ref;S!==void 0&&(p.delete(S),v.unregister(S))}function D(R){H(R.target)}function G(R){P(R.target)}function H(R){R.removeEventListener("dispose",D),I(R),z(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&d.delete(R)}function P(R){R.removeEventListener("dispose",G),I(R),re(R)}function V(){for(let R of p){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?P(S):H(S))}p.clear(),d.clear()}function z(R){let S=n.get(R);if(S.__webglInit===void 0)return;let Y=R.source,he=f.get(Y);if(he){let ce=he[S.__cacheKey];ce.usedTimes--,ce.usedTimes===0&&N(R),Object.keys(he).length===0&&f.delete(Y)}n.remove(R)}function N(R){let S=n.get(R);i.deleteTexture(S.__webglTexture);let Y=R.source,he=f.get(Y);delete he[S.__cacheKey],o.memory.textures--}function re(R){let S=n.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let Y=R.depthTexture;if(Y&&Y.renderTarget===R&&H(Y),R.isWebGLCubeRenderTarget)for(let ce=0;ce<6;ce++){if(Array.isArray(S.__webglFramebuffer[ce]))for(let Te=0;Te<S.__webglFramebuffer[ce].length;Te++)i.deleteFramebuffer(S.__webglFramebuffer[ce][Te]);else i.deleteFramebuffer(S.__webglFramebuffer[ce]);S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer[ce])}else{if(Array.isArray(S.__webglFramebuffer))for(let ce=0;ce<S.__webglFramebuffer.length;ce++)i.deleteFramebuffer(S.__webglFramebuffer[ce]);else i.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&i.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&i.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ce=0;ce<S.__webglColorRenderbuffer.length;ce++)S.__webglColorRenderbuffer[ce]&&i.deleteRenderbuffer(S.__webglColorRenderbuffer[ce]);S.__webglDepthRenderbuffer&&i.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let he=R.textures;for(let ce=0,Te=he.length;ce<Te;ce++){let Me=n.get(he[ce]);Me.__webglTexture&&(i.deleteTexture(Me.__webglTexture),o.memory.textures--),n.remove(he[ce])}n.remove(R)}let q=0;function $(){q=0}function te(){return q}function ue(R){q=R}function de(){let R=q;return R>=s.maxTextures&&ot("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,R}function K(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function xe(R,S){let Y=n.get(R);if(R.isVideoTexture&&It(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&Y.__version!==R.version){let he=R.image;if(he===null)ot("WebGLRenderer: Texture marked for update but no image data found.");else if(he.complete===!1)ot("WebGLRenderer: Texture marked for update but image is incomplete");else{me(Y,R,S);return}}else R.isExternalTexture&&(Y.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,Y.__webglTexture,i.TEXTURE0+S)}function be(R,S){let Y=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&Y.__version!==R.version){me(Y,R,S);return}else R.isExternalTexture&&(Y.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,Y.__webglTexture,i.TEXTURE0+S)}function Pe(R,S){let Y=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&Y.__version!==R.version){me(Y,R,S);return}t.bindTexture(i.TEXTURE_3D,Y.__webglTexture,i.TEXTURE0+S)}function Ee(R,S){let Y=n.get(R);if(R.version>0&&Y.__version!==R.version){Ne(Y,R,S);return}t.bindTexture(i.TEXTURE_CUBE_MAP,Y.__webglTexture,i.TEXTURE0+S)}let Ve={[hc]:i.REPEAT,[ts]:i.CLAMP_TO_EDGE,[dc]:i.MIRRORED_REPEAT},Qe={[Dn]:i.NEAREST,[$g]:i.NEAREST_MIPMAP_NEAREST,[qa]:i.NEAREST_MIPMAP_LINEAR,[Kn]:i.LINEAR,[kc]:i.LINEAR_MIPMAP_NEAREST,[ws]:i.LINEAR_MIPMAP_LINEAR},Ge={[jg]:i.NEVER,[Qd]:i.ALWAYS,[Qg]:i.LESS,[Kd]:i.LEQUAL,[e0]:i.EQUAL,[jd]:i.GEQUAL,[t0]:i.GREATER,[n0]:i.NOTEQUAL};function ct(R,S){if(S.type===Vi&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===Kn||S.magFilter===kc||S.magFilter===qa||S.magFilter===ws||S.minFilter===Kn||S.minFilter===kc||S.minFilter===qa||S.minFilter===ws)&&ot("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Ve[S.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Ve[S.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Ve[S.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,Qe[S.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,Qe[S.minFilter]),S.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Ge[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Dn||S.minFilter!==qa&&S.minFilter!==ws||S.type===Vi&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||n.get(S).__currentAnisotropy){let Y=e.get("EXT_texture_filter_anisotropic");i.texParameterf(R,Y.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),n.get(S).__currentAnisotropy=S.anisotropy}}}function ft(R,S){let Y=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",D),U(S));let he=S.source,ce=f.get(he);ce===void 0&&(ce={},f.set(he,ce));let Te=K(S);if(Te!==R.__cacheKey){ce[Te]===void 0&&(ce[Te]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,Y=!0),ce[Te].usedTimes++;let Me=ce[R.__cacheKey];Me!==void 0&&(ce[R.__cacheKey].usedTimes--,Me.usedTimes===0&&N(S)),R.__cacheKey=Te,R.__webglTexture=ce[Te].texture}return Y}function tt(R,S,Y){return Math.floor(Math.floor(R/Y)/S)}function ye(R,S,Y,he){let Te=R.updateRanges;if(Te.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,S.width,S.height,Y,he,S.data);else{Te.sort((k,le)=>k.start-le.start);let Me=0;for(let k=1;k<Te.length;k++){let le=Te[Me],ae=Te[k],Re=le.start+le.count,Se=tt(ae.start,S.width,4),Ae=tt(le.start,S.width,4);ae.start<=Re+1&&Se===Ae&&tt(ae.start+ae.count-1,S.width,4)===Se?le.count=Math.max(le.count,ae.start+ae.count-le.start):(++Me,Te[Me]=ae)}Te.length=Me+1;let se=t.getParameter(i.UNPACK_ROW_LENGTH),oe=t.getParameter(i.UNPACK_SKIP_PIXELS),_e=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,S.width);for(let k=0,le=Te.length;k<le;k++){let ae=Te[k],Re=Math.floor(ae.start/4),Se=Math.ceil(ae.count/4),Ae=Re%S.width,Je=Math.floor(Re/S.width),it=Se,pe=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ae),t.pixelStorei(i.UNPACK_SKIP_ROWS,Je),t.texSubImage2D(i.TEXTURE_2D,0,Ae,Je,it,pe,Y,he,S.data)}R.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,se),t.pixelStorei(i.UNPACK_SKIP_PIXELS,oe),t.pixelStorei(i.UNPACK_SKIP_ROWS,_e)}}function me(R,S,Y){let he=i.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(he=i.TEXTURE_2D_ARRAY),S.isData3DTexture&&(he=i.TEXTURE_3D);let ce=ft(R,S),Te=S.source;t.bindTexture(he,R.__webglTexture,i.TEXTURE0+Y);let Me=n.get(Te);if(Te.version!==Me.__version||ce===!0){if(t.activeTexture(i.TEXTURE0+Y),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let pe=Et.getPrimaries(Et.workingColorSpace),He=S.colorSpace===Es?null:Et.getPrimaries(S.colorSpace),st=S.colorSpace===Es||pe===He?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,st)}t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment);let oe=y(S.image,!1,s.maxTextureSize);oe=Ye(S,oe);let _e=r.convert(S.format,S.colorSpace),k=r.convert(S.type),le=E(S.internalFormat,_e,k,S.normalized,S.colorSpace,S.isVideoTexture);ct(he,S);let ae,Re=S.mipmaps,Se=S.isVideoTexture!==!0,Ae=Me.__version===void 0||ce===!0,Je=Te.dataReady,it=M(S,oe);if(S.isDepthTexture)le=x(S.format===Ts,S.type),Ae&&(Se?t.texStorage2D(i.TEXTURE_2D,1,le,oe.width,oe.height):t.texImage2D(i.TEXTURE_2D,0,le,oe.width,oe.height,0,_e,k,null));else if(S.isDataTexture)if(Re.length>0){Se&&Ae&&t.texStorage2D(i.TEXTURE_2D,it,le,Re[0].width,Re[0].height);for(let pe=0,He=Re.length;pe<He;pe++)ae=Re[pe],Se?Je&&t.texSubImage2D(i.TEXTURE_2D,pe,0,0,ae.width,ae.height,_e,k,ae.data):t.texImage2D(i.TEXTURE_2D,pe,le,ae.width,ae.height,0,_e,k,ae.data);S.generateMipmaps=!1}else Se?(Ae&&t.texStorage2D(i.TEXTURE_2D,it,le,oe.width,oe.height),Je&&ye(S,oe,_e,k)):t.texImage2D(i.TEXTURE_2D,0,le,oe.width,oe.height,0,_e,k,oe.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){Se&&Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,it,le,Re[0].width,Re[0].height,oe.depth);for(let pe=0,He=Re.length;pe<He;pe++)if(ae=Re[pe],S.format!==Wi)if(_e!==null)if(Se){if(Je)if(S.layerUpdates.size>0){let st=af(ae.width,ae.height,S.format,S.type);for(let O of S.layerUpdates){let ie=ae.data.subarray(O*st/ae.data.BYTES_PER_ELEMENT,(O+1)*st/ae.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,pe,0,0,O,ae.width,ae.height,1,_e,ie)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,pe,0,0,0,ae.width,ae.height,oe.depth,_e,ae.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,pe,le,ae.width,ae.height,oe.depth,0,ae.data,0,0);else ot("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Se?Je&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,pe,0,0,0,ae.width,ae.height,oe.depth,_e,k,ae.data):t.texImage3D(i.TEXTURE_2D_ARRAY,pe,le,ae.width,ae.height,oe.depth,0,_e,k,ae.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{Se&&Ae&&t.texStorage2D(i.TEXTURE_2D,it,le,Re[0].width,Re[0].height);for(let pe=0,He=Re.length;pe<He;pe++)ae=Re[pe],S.format!==Wi?_e!==null?Se?Je&&t.compressedTexSubImage2D(i.TEXTURE_2D,pe,0,0,ae.width,ae.height,_e,ae.data):t.compressedTexImage2D(i.TEXTURE_2D,pe,le,ae.width,ae.height,0,ae.data):ot("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Se?Je&&t.texSubImage2D(i.TEXTURE_2D,pe,0,0,ae.width,ae.height,_e,k,ae.data):t.texImage2D(i.TEXTURE_2D,pe,le,ae.width,ae.height,0,_e,k,ae.data)}else if(S.isDataArrayTexture)if(Se){if(Ae&&t.texStorage3D(i.TEXTURE_2D_ARRAY,it,le,oe.width,oe.height,oe.depth),Je)if(S.layerUpdates.size>0){let pe=af(oe.width,oe.height,S.format,S.type);for(let He of S.layerUpdates){let st=oe.data.subarray(He*pe/oe.data.BYTES_PER_ELEMENT,(He+1)*pe/oe.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,He,oe.width,oe.height,1,_e,k,st)}S.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,oe.width,oe.height,oe.depth,_e,k,oe.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,le,oe.width,oe.height,oe.depth,0,_e,k,oe.data);else if(S.isData3DTexture)Se?(Ae&&t.texStorage3D(i.TEXTURE_3D,it,le,oe.width,oe.height,oe.depth),Je&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,oe.width,oe.height,oe.depth,_e,k,oe.data)):t.texImage3D(i.TEXTURE_3D,0,le,oe.width,oe.height,oe.depth,0,_e,k,oe.data);else if(S.isFramebufferTexture){if(Ae)if(Se)t.texStorage2D(i.TEXTURE_2D,it,le,oe.width,oe.height);else{let pe=oe.width,He=oe.height;for(let st=0;st<it;st++)t.texImage2D(i.TEXTURE_2D,st,le,pe,He,0,_e,k,null),pe>>=1,He>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in i){let pe=i.canvas;if(pe.hasAttribute("layoutsubtree")||pe.setAttribute("layoutsubtree","true"),oe.parentNode!==pe){pe.appendChild(oe),d.add(S),pe.onpaint=He=>{let st=He.changedElements;for(let O of d)st.includes(O.image)&&(O.needsUpdate=!0)},pe.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,oe);else{let st=i.RGBA,O=i.RGBA,ie=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,st,O,ie,oe)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Re.length>0){if(Se&&Ae){let pe=Ke(Re[0]);t.texStorage2D(i.TEXTURE_2D,it,le,pe.width,pe.height)}for(let pe=0,He=Re.length;pe<He;pe++)ae=Re[pe],Se?Je&&t.texSubImage2D(i.TEXTURE_2D,pe,0,0,_e,k,ae):t.texImage2D(i.TEXTURE_2D,pe,le,_e,k,ae);S.generateMipmaps=!1}else if(Se){if(Ae){let pe=Ke(oe);t.texStorage2D(i.TEXTURE_2D,it,le,pe.width,pe.height)}Je&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,_e,k,oe)}else t.texImage2D(i.TEXTURE_2D,0,le,_e,k,oe);A(S)&&S.mipmapsAutoUpdate===!0&&b(he),Me.__version=Te.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Ne(R,S,Y){if(S.image.length!==6)return;let he=ft(R,S),ce=S.source;t.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+Y);let Te=n.get(ce);if(ce.version!==Te.__version||he===!0){t.activeTexture(i.TEXTURE0+Y);let Me=Et.getPrimaries(Et.workingColorSpace),se=S.colorSpace===Es?null:Et.getPrimaries(S.colorSpace),oe=S.colorSpace===Es||Me===se?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,oe);let _e=S.isCompressedTexture||S.image[0].isCompressedTexture,k=S.image[0]&&S.image[0].isDataTexture,le=[];for(let O=0;O<6;O++)!_e&&!k?le[O]=y(S.image[O],!0,s.maxCubemapSize):le[O]=k?S.image[O].image:S.image[O],le[O]=Ye(S,le[O]);let ae=le[0],Re=r.convert(S.format,S.colorSpace),Se=r.convert(S.type),Ae=E(S.internalFormat,Re,Se,S.normalized,S.colorSpace),Je=S.isVideoTexture!==!0,it=Te.__version===void 0||he===!0,pe=ce.dataReady,He=M(S,ae);ct(i.TEXTURE_CUBE_MAP,S);let st;if(S.isDepthTexture){if(Ae=x(S.format===Ts,S.type),it)if(Je)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ae,ae.width,ae.height);else for(let O=0;O<6;O++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,0,Ae,ae.width,ae.height,0,Re,Se,null)}else if(_e){Je&&it&&t.texStorage2D(i.TEXTURE_CUBE_MAP,He,Ae,ae.width,ae.height);for(let O=0;O<6;O++){st=le[O].mipmaps;for(let ie=0;ie<st.length;ie++){let ge=st[ie];S.format!==Wi?Re!==null?Je?pe&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,ie,0,0,ge.width,ge.height,Re,ge.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,ie,Ae,ge.width,ge.height,0,ge.data):ot("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Je?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,ie,0,0,ge.width,ge.height,Re,Se,ge.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,ie,Ae,ge.width,ge.height,0,Re,Se,ge.data)}}}else{if(st=S.mipmaps,Je&&it){st.length>0&&He++;let O=Ke(le[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,He,Ae,O.width,O.height)}for(let O=0;O<6;O++)if(k){Je?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,0,0,0,le[O].width,le[O].height,Re,Se,le[O].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,0,Ae,le[O].width,le[O].height,0,Re,Se,le[O].data);for(let ie=0;ie<st.length;ie++){let Be=st[ie].image[O].image;Je?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,ie+1,0,0,Be.width,Be.height,Re,Se,Be.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,ie+1,Ae,Be.width,Be.height,0,Re,Se,Be.data)}}else{Je?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,0,0,0,Re,Se,le[O]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,0,Ae,Re,Se,le[O]);for(let ie=0;ie<st.length;ie++){let ge=st[ie];Je?pe&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,ie+1,0,0,Re,Se,ge.image[O]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+O,ie+1,Ae,Re,Se,ge.image[O])}}}A(S)&&S.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),Te.__version=ce.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function qe(R,S,Y,he,ce,Te){let Me=r.convert(Y.format,Y.colorSpace),se=r.convert(Y.type),oe=E(Y.internalFormat,Me,se,Y.normalized,Y.colorSpace),_e=n.get(S),k=n.get(Y);if(k.__renderTarget=S,!_e.__hasExternalTextures){let le=Math.max(1,S.width>>Te),ae=Math.max(1,S.height>>Te);ce===i.TEXTURE_3D||ce===i.TEXTURE_2D_ARRAY?t.texImage3D(ce,Te,oe,le,ae,S.depth,0,Me,se,null):t.texImage2D(ce,Te,oe,le,ae,0,Me,se,null)}t.bindFramebuffer(i.FRAMEBUFFER,R),we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,he,ce,k.__webglTexture,0,ht(S)):(ce===i.TEXTURE_2D||ce>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&ce<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,he,ce,k.__webglTexture,Te),t.bindFramebuffer(i.FRAMEBUFFER,null)}function nt(R,S,Y){if(i.bindRenderbuffer(i.RENDERBUFFER,R),S.depthBuffer){let he=S.depthTexture,ce=he&&he.isDepthTexture?he.type:null,Te=x(S.stencilBuffer,ce),Me=S.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ht(S),Te,S.width,S.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,ht(S),Te,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,Te,S.width,S.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Me,i.RENDERBUFFER,R)}else{let he=S.textures;for(let ce=0;ce<he.length;ce++){let Te=he[ce],Me=r.convert(Te.format,Te.colorSpace),se=r.convert(Te.type),oe=E(Te.internalFormat,Me,se,Te.normalized,Te.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ht(S),oe,S.width,S.height):Y?i.renderbufferStorageMultisample(i.RENDERBUFFER,ht(S),oe,S.width,S.height):i.renderbufferStorage(i.RENDERBUFFER,oe,S.width,S.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function ut(R,S,Y){let he=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ce=n.get(S.depthTexture);ce.__renderTarget=S;let Te=he?S.depthTexture.image[0]:S.depthTexture.image;(!ce.__webglTexture||Te.width!==S.width||Te.height!==S.height)&&(Te.width=S.width,Te.height=S.height,S.depthTexture.needsUpdate=!0),he?Ee(S.depthTexture,0):xe(S.depthTexture,0);let Me=ce.__webglTexture,se=ht(S),oe=he?i.TEXTURE_CUBE_MAP_POSITIVE_X+Y:i.TEXTURE_2D,_e=S.depthTexture.format===Ts?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(S.depthTexture.format===bs)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_e,oe,Me,0,se):i.framebufferTexture2D(i.FRAMEBUFFER,_e,oe,Me,0);else if(S.depthTexture.format===Ts)we(S)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,_e,oe,Me,0,se):i.framebufferTexture2D(i.FRAMEBUFFER,_e,oe,Me,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Jt(R){let S=n.get(R),Y=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let he=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),he){let ce=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,he.removeEventListener("dispose",ce)};he.addEventListener("dispose",ce),S.__depthDisposeCallback=ce}S.__boundDepthTexture=he}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(Y)for(let he=0;he<6;he++)ut(S.__webglFramebuffer[he],R,he);else R.texture.mipmaps.length>0?ut(S.__webglFramebuffer[0],R,0):ut(S.__webglFramebuffer,R,0);else if(Y){S.__webglDepthbuffer=[];for(let he=0;he<6;he++)if(t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[he]),S.__webglDepthbuffer[he]===void 0)S.__webglDepthbuffer[he]=i.createRenderbuffer(),nt(S.__webglDepthbuffer[he],R,!1);else{let ce=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Te=S.__webglDepthbuffer[he];i.bindRenderbuffer(i.RENDERBUFFER,Te),i.framebufferRenderbuffer(i.FRAMEBUFFER,ce,i.RENDERBUFFER,Te)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=i.createRenderbuffer(),nt(S.__webglDepthbuffer,R,!1);else{let ce=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Te=S.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,Te),i.framebufferRenderbuffer(i.FRAMEBUFFER,ce,i.RENDERBUFFER,Te)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Pt(R,S,Y){let he=n.get(R);S!==void 0&&qe(he.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),Y!==void 0&&Jt(R)}function kt(R){let S=R.texture,Y=n.get(R),he=n.get(S);R.addEventListener("dispose",G),U(R);let ce=R.textures,Te=R.isWebGLCubeRenderTarget===!0,Me=ce.length>1;if(Me||(he.__webglTexture===void 0&&(he.__webglTexture=i.createTexture()),he.__version=S.version,o.memory.textures++),Te){Y.__webglFramebuffer=[];for(let se=0;se<6;se++)if(S.mipmaps.length>0){Y.__webglFramebuffer[se]=[];for(let oe=0;oe<S.mipmaps.length;oe++)Y.__webglFramebuffer[se][oe]=i.createFramebuffer()}else Y.__webglFramebuffer[se]=i.createFramebuffer()}else{if(S.mipmaps.length>0){Y.__webglFramebuffer=[];for(let se=0;se<S.mipmaps.length;se++)Y.__webglFramebuffer[se]=i.createFramebuffer()}else Y.__webglFramebuffer=i.createFramebuffer();if(Me)for(let se=0,oe=ce.length;se<oe;se++){let _e=n.get(ce[se]);_e.__webglTexture===void 0&&(_e.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&we(R)===!1){Y.__webglMultisampledFramebuffer=i.createFramebuffer(),Y.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,Y.__webglMultisampledFramebuffer);for(let se=0;se<ce.length;se++){let oe=ce[se];Y.__webglColorRenderbuffer[se]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,Y.__webglColorRenderbuffer[se]);let _e=r.convert(oe.format,oe.colorSpace),k=r.convert(oe.type),le=E(oe.internalFormat,_e,k,oe.normalized,oe.colorSpace,R.isXRRenderTarget===!0),ae=ht(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,ae,le,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+se,i.RENDERBUFFER,Y.__webglColorRenderbuffer[se])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(Y.__webglDepthRenderbuffer=i.createRenderbuffer(),nt(Y.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(Te){t.bindTexture(i.TEXTURE_CUBE_MAP,he.__webglTexture),ct(i.TEXTURE_CUBE_MAP,S);for(let se=0;se<6;se++)if(S.mipmaps.length>0)for(let oe=0;oe<S.mipmaps.length;oe++)qe(Y.__webglFramebuffer[se][oe],R,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+se,oe);else qe(Y.__webglFramebuffer[se],R,S,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+se,0);A(S)?b(i.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(Me){for(let se=0,oe=ce.length;se<oe;se++){let _e=ce[se],k=n.get(_e),le=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(le=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(le,k.__webglTexture),ct(le,_e),qe(Y.__webglFramebuffer,R,_e,i.COLOR_ATTACHMENT0+se,le,0),A(_e)&&b(le)}t.unbindTexture()}else{let se=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(se,he.__webglTexture),ct(se,S),S.mipmaps.length>0)for(let oe=0;oe<S.mipmaps.length;oe++)qe(Y.__webglFramebuffer[oe],R,S,i.COLOR_ATTACHMENT0,se,oe);else qe(Y.__webglFramebuffer,R,S,i.COLOR_ATTACHMENT0,se,0);A(S)?b(se):S.mipmaps.length>0&&i.texParameteri(se,i.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Jt(R)}function B(R){let S=R.textures;for(let Y=0,he=S.length;Y<he;Y++){let ce=S[Y];if(A(ce)&&ce.mipmapsAutoUpdate===!0){let Te=C(R),Me=n.get(ce).__webglTexture;t.bindTexture(Te,Me),b(Te),t.unbindTexture()}}}let De=[];function et(R){if(R.samples>0){if(we(R)===!1){let S=R.textures,Y=R.width,he=R.height,ce=i.COLOR_BUFFER_BIT,Te=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Me=n.get(R),se=S.length>1;if(se)for(let _e=0;_e<S.length;_e++)t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,Me.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglFramebuffer);for(let _e=0;_e<S.length;_e++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ce|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ce|=i.STENCIL_BUFFER_BIT)),se){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Me.__webglColorRenderbuffer[_e]);let k=n.get(S[_e]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,k,0)}i.blitFramebuffer(0,0,Y,he,0,0,Y,he,ce,i.NEAREST),c===!0&&(De.length=0,De.push(i.COLOR_ATTACHMENT0+_e),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&De.push(Te),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,De))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),se)for(let _e=0;_e<S.length;_e++){t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.RENDERBUFFER,Me.__webglColorRenderbuffer[_e]);let k=n.get(S[_e]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,Me.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+_e,i.TEXTURE_2D,k,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,Me.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&c){let S=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[S])}}}function ht(R){return Math.min(s.maxSamples,R.samples)}function we(R){let S=n.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function It(R){let S=o.render.frame;u.get(R)!==S&&(u.set(R,S),R.update())}function Ye(R,S){let Y=R.colorSpace,he=R.format,ce=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||Y!==wa&&Y!==Es&&(Et.getTransfer(Y)===Ut?(he!==Wi||ce!==si)&&ot("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):lt("WebGLTextures: Unsupported texture color space:",Y)),S}function Ke(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(l.width=R.naturalWidth||R.width,l.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(l.width=R.displayWidth,l.height=R.displayHeight):(l.width=R.width,l.height=R.height),l}this.allocateTextureUnit=de,this.resetTextureUnits=$,this.getTextureUnits=te,this.setTextureUnits=ue,this.setTexture2D=xe,this.setTexture2DArray=be,this.setTexture3D=Pe,this.setTextureCube=Ee,this.rebindTextures=Pt,this.setupRenderTarget=kt,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=et,this.setupDepthRenderbuffer=Jt,this.setupFrameBufferTexture=qe,this.useMultisampledRTT=we,this.dispose=V}function m1(i,e){function t(n,s=Es){let r,o=Et.getTransfer(s);if(n===si)return i.UNSIGNED_BYTE;if(n===Gc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Vc)return i.UNSIGNED_SHORT_5_5_5_1;if(n===qd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Yd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Wd)return i.BYTE;if(n===Xd)return i.SHORT;if(n===Bo)return i.UNSIGNED_SHORT;if(n===zc)return i.INT;if(n===Gi)return i.UNSIGNED_INT;if(n===Vi)return i.FLOAT;if(n===Hi)return i.HALF_FLOAT;if(n===$d)return i.ALPHA;if(n===Zd)return i.RGB;if(n===Wi)return i.RGBA;if(n===bs)return i.DEPTH_COMPONENT;if(n===Ts)return i.DEPTH_STENCIL;if(n===Jd)return i.RED;if(n===Hc)return i.RED_INTEGER;if(n===ar)return i.RG;if(n===Wc)return i.RG_INTEGER;if(n===Xc)return i.RGBA_INTEGER;if(n===Ya||n===$a||n===Za||n===Ja)if(o===Ut)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ya)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===$a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Za)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Ja)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ya)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===$a)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Za)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Ja)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===qc||n===Yc||n===$c||n===Zc)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===qc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Yc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===$c)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Zc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Jc||n===Kc||n===jc||n===Qc||n===eu||n===Ka||n===tu)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Jc||n===Kc)return o===Ut?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===jc)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Qc)return r.COMPRESSED_R11_EAC;if(n===eu)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Ka)return r.COMPRESSED_RG11_EAC;if(n===tu)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===nu||n===iu||n===su||n===ru||n===ou||n===au||n===lu||n===cu||n===uu||n===hu||n===du||n===fu||n===pu||n===mu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===nu)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===iu)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===su)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===ru)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===ou)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===au)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===lu)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===cu)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===uu)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===hu)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===du)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===fu)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===pu)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===mu)return o===Ut?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===gu||n===xu||n===_u)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===gu)return o===Ut?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===xu)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===_u)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===vu||n===yu||n===ja||n===bu)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===vu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===yu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===ja)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===bu)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Nr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var g1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,x1=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,gf=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ua(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new rs({vertexShader:g1,fragmentShader:x1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Nn(new Oa(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},xf=class extends ns{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,u=null,d=null,h=null,f=null,p=null,v=typeof XRWebGLBinding<"u",g=new gf,m={},y=t.getContextAttributes(),A=null,b=null,C=[],E=[],x=new St,M=null,U=null,I=new Jn;I.viewport=new tn;let D=new Jn;D.viewport=new tn;let G=[I,D],H=new Uc,P=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let xe=C[K];return xe===void 0&&(xe=new Co,C[K]=xe),xe.getTargetRaySpace()},this.getControllerGrip=function(K){let xe=C[K];return xe===void 0&&(xe=new Co,C[K]=xe),xe.getGripSpace()},this.getHand=function(K){let xe=C[K];return xe===void 0&&(xe=new Co,C[K]=xe),xe.getHandSpace()};function z(K){let xe=E.indexOf(K.inputSource);if(xe===-1)return;let be=C[xe];be!==void 0&&(be.update(K.inputSource,K.frame,l||o),be.dispatchEvent({type:K.type,data:K.inputSource}))}function N(){s.removeEventListener("select",z),s.removeEventListener("selectstart",z),s.removeEventListener("selectend",z),s.removeEventListener("squeeze",z),s.removeEventListener("squeezestart",z),s.removeEventListener("squeezeend",z),s.removeEventListener("end",N),s.removeEventListener("inputsourceschange",re);for(let K=0;K<C.length;K++){let xe=E[K];xe!==null&&(E[K]=null,C[K].disconnect(xe))}P=null,V=null,g.reset();for(let K in m)delete m[K];if(e.setRenderTarget(A),f=null,h=null,d=null,s=null,b=null,de.stop(),n.isPresenting=!1,e.setPixelRatio(M),e.setSize(x.width,x.height,!1),U!==null){let K=U.camera;K.fov=U.fov,K.zoom=U.zoom,K.updateProjectionMatrix(),U=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){r=K,n.isPresenting===!0&&ot("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){a=K,n.isPresenting===!0&&ot("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(K){l=K},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(K){if(s=K,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",z),s.addEventListener("selectstart",z),s.addEventListener("selectend",z),s.addEventListener("squeeze",z),s.addEventListener("squeezestart",z),s.addEventListener("squeezeend",z),s.addEventListener("end",N),s.addEventListener("inputsourceschange",re),y.xrCompatible!==!0&&await t.makeXRCompatible(),M=e.getPixelRatio(),e.getSize(x),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let be=null,Pe=null,Ee=null;y.depth&&(Ee=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,be=y.stencil?Ts:bs,Pe=y.stencil?Nr:Gi);let Ve={colorFormat:t.RGBA8,depthFormat:Ee,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Ve),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),b=new _i(h.textureWidth,h.textureHeight,{format:Wi,type:si,depthTexture:new Ss(h.textureWidth,h.textureHeight,Pe,void 0,void 0,void 0,void 0,void 0,void 0,be),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let be={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,be),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new _i(f.framebufferWidth,f.framebufferHeight,{format:Wi,type:si,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),de.setContext(s),de.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function re(K){for(let xe=0;xe<K.removed.length;xe++){let be=K.removed[xe],Pe=E.indexOf(be);Pe>=0&&(E[Pe]=null,C[Pe].disconnect(be))}for(let xe=0;xe<K.added.length;xe++){let be=K.added[xe],Pe=E.indexOf(be);if(Pe===-1){for(let Ve=0;Ve<C.length;Ve++)if(Ve>=E.length){E.push(be),Pe=Ve;break}else if(E[Ve]===null){E[Ve]=be,Pe=Ve;break}if(Pe===-1)break}let Ee=C[Pe];Ee&&Ee.connect(be)}}function q(K,xe){xe===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(xe.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(s===null)return;let xe=K.near,be=K.far;g.texture!==null&&(g.depthNear>0&&(xe=g.depthNear),g.depthFar>0&&(be=g.depthFar)),H.near=D.near=I.near=xe,H.far=D.far=I.far=be,(P!==H.near||V!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),P=H.near,V=H.far),H.layers.mask=K.layers.mask|6,I.layers.mask=H.layers.mask&-5,D.layers.mask=H.layers.mask&-3;let Pe=K.parent,Ee=H.cameras;q(H,Pe);for(let Ve=0;Ve<Ee.length;Ve++)q(Ee[Ve],Pe);H.projectionMatrix.copy(I.projectionMatrix),H.projectionMatrixInverse.copy(I.projectionMatrixInverse),U===null&&K.isPerspectiveCamera&&(U={camera:K,fov:K.fov,zoom:K.zoom}),$(K,H,Pe)};function $(K,xe,be){be===null?K.matrix.copy(xe.matrixWorld):(K.matrix.copy(be.matrixWorld),K.matrix.invert(),K.matrix.multiply(xe.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(xe.projectionMatrix),K.projectionMatrixInverse.copy(xe.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=pc*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(h===null&&f===null))return c},this.setFoveation=function(K){c=K,h!==null&&(h.fixedFoveation=K),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=K)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(H)},this.getCameraTexture=function(K){return m[K]};let te=null;function ue(K,xe){if(u=xe.getViewerPose(l||o),p=xe,u!==null){let be=u.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Pe=!1;be.length!==H.cameras.length&&(H.cameras.length=0,Pe=!0);for(let Ge=0;Ge<be.length;Ge++){let ct=be[Ge],ft=null;if(f!==null)ft=f.getViewport(ct);else{let ye=d.getViewSubImage(h,ct);ft=ye.viewport,Ge===0&&(e.setRenderTargetTextures(b,ye.colorTexture,ye.depthStencilTexture),e.setRenderTarget(b))}let tt=G[Ge];tt===void 0&&(tt=new Jn,tt.layers.enable(Ge),tt.viewport=new tn,G[Ge]=tt),tt.matrix.fromArray(ct.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(ct.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(ft.x,ft.y,ft.width,ft.height),Ge===0&&(H.matrix.copy(tt.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Pe===!0&&H.cameras.push(tt)}let Ee=s.enabledFeatures;if(Ee&&Ee.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=n.getBinding();let Ge=d.getDepthInformation(be[0]);Ge&&Ge.isValid&&Ge.texture&&g.init(Ge,s.renderState)}if(Ee&&Ee.includes("camera-access")&&v){e.state.unbindTexture(),d=n.getBinding();for(let Ge=0;Ge<be.length;Ge++){let ct=be[Ge].camera;if(ct){let ft=m[ct];ft||(ft=new Ua,m[ct]=ft);let tt=d.getCameraImage(ct);ft.sourceTexture=tt}}}}for(let be=0;be<C.length;be++){let Pe=E[be],Ee=C[be];Pe!==null&&Ee!==void 0&&Ee.update(Pe,xe,l||o)}te&&te(K,xe),xe.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:xe}),p=null}let de=new N0;de.setAnimationLoop(ue),this.setAnimationLoop=function(K){te=K},this.dispose=function(){}}},_1=new Qt,W0=new dt;W0.set(-1,0,0,0,1,0,0,0,1);function v1(i,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,sf(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,y,A,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),d(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),h(g,m),m.isMeshPhysicalMaterial&&f(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),v(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?c(g,m,y,A):m.isSpriteMaterial?l(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===Qn&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===Qn&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let y=e.get(m),A=y.envMap,b=y.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(_1.makeRotationFromEuler(b)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(W0),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function c(g,m,y,A){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*y,g.scale.value=A*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function l(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function d(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function h(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,y){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===Qn&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function v(g,m){let y=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function y1(i,e,t,n){let s={},r={};function o(y,A){let b=A.program;n.uniformBlockBinding(y,b,s[y.id])}function a(y,A){let b=s[y.id];b===void 0&&(p(y),b=c(y),s[y.id]=b,y.addEventListener("dispose",g));let C=A.program;n.updateUBOMapping(y,C);let E=e.render.frame;r[y.id]!==E&&(l(y),r[y.id]=E)}function c(y){let A=i.createBuffer(),b=y.__size,C=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,b,C),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(y){let A=s[y.id],b=y.uniforms,C=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,x=b.length;E<x;E++){let M=b[E];if(Array.isArray(M))for(let U=0,I=M.length;U<I;U++)u(M[U],E,U,C);else u(M,E,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(y,A,b,C){if(h(y,A,b,C)===!0){let E=y.__offset,x=y.value;if(Array.isArray(x)){let M=0;for(let U=0;U<x.length;U++){let I=x[U],D=v(I,!0);d(I,y.__data,M),M+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else d(x,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,y.__data)}}function d(y,A,b){typeof y=="number"||typeof y=="boolean"?A[b]=y:y.isMatrix3?(A[b]=y.elements[0],A[b+1]=y.elements[1],A[b+2]=y.elements[2],A[b+3]=0,A[b+4]=y.elements[3],A[b+5]=y.elements[4],A[b+6]=y.elements[5],A[b+7]=0,A[b+8]=y.elements[6],A[b+9]=y.elements[7],A[b+10]=y.elements[8],A[b+11]=0):ArrayBuffer.isView(y)?A.set(y.subarray(0,A.length-b),b):y.toArray(A,b)}function h(y,A,b,C){let E=y.value,x=A+"_"+b;if(Array.isArray(E)){C[x]===void 0&&(C[x]=[]);let M=C[x],U=!1;for(let I=0;I<E.length;I++)f(E[I],M,I)===!0&&(U=!0);return U}return f(E,C,x)}function f(y,A,b){if(A[b]===void 0)return typeof y=="number"||typeof y=="boolean"?A[b]=y:ArrayBuffer.isView(y)?A[b]=y.slice():A[b]=y.clone(),!0;{let C=A[b];if(typeof y=="number"||typeof y=="boolean"){if(C!==y)return A[b]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(C.equals(y)===!1)return C.copy(y),!0}}return!1}function p(y){let A=y.uniforms,b=0,C=16;for(let x=0,M=A.length;x<M;x++){let U=Array.isArray(A[x])?A[x]:[A[x]];for(let I=0,D=U.length;I<D;I++){let G=U[I],H=Array.isArray(G.value)?G.value:[G.value],P=Array.isArray(A[x])||Array.isArray(G.value),V=b;for(let N=0,re=H.length;N<re;N++){let q=H[N],$=v(q,P),te=b%C,ue=te%$.boundary,de=te+ue;b+=ue,de!==0&&C-de<$.storage&&(b+=C-de),N===0&&(V=b),b+=$.storage}let z=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new z((b-V)/Float32Array.BYTES_PER_ELEMENT),G.__offset=V}}let E=b%C;return E>0&&(b+=C-E),y.__size=b,y.__cache={},this}function v(y,A){let b={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(b.boundary=4,b.storage=4):y.isVector2?(b.boundary=8,b.storage=8):y.isVector3||y.isColor?(b.boundary=16,b.storage=12):y.isVector4?(b.boundary=16,b.storage=16):y.isMatrix3?(b.boundary=16,b.storage=48):y.isMatrix4?(b.boundary=16,b.storage=64):y.isTexture?ot("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(b.boundary=16,b.storage=y.byteLength):ot("WebGLRenderer: Unsupported uniform value type.",y),A===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(y){let A=y.target;A.removeEventListener("dispose",g),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var b1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),as=null;function M1(){return as===null&&(as=new vc(b1,16,16,ar,Hi),as.name="DFG_LUT",as.minFilter=Kn,as.magFilter=Kn,as.wrapS=ts,as.wrapT=ts,as.generateMipmaps=!1,as.needsUpdate=!0),as}var Eu=class{constructor(e={}){let{canvas:t=s0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:f=si}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let v=f,g=new Set([Xc,Wc,Hc]),m=new Set([si,Gi,Bo,Nr,Gc,Vc]),y=new Uint32Array(4),A=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,E=null,x=[],M=[],U=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=os,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let I=this,D=!1,G=null,H=null,P=null,V=null;this._outputColorSpace=Zn;let z=0,N=0,re=null,q=-1,$=null,te=new tn,ue=new tn,de=null,K=new vt(0),xe=0,be=t.width,Pe=t.height,Ee=1,Ve=null,Qe=null,Ge=new tn(0,0,be,Pe),ct=new tn(0,0,be,Pe),ft=!1,tt=new tr,ye=new yc,me=!1,Ne=!1,qe=new Qt,nt=new ee,ut=new tn,Jt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Pt=!1;function kt(){return re===null?Ee:1}let B=n;function De(T,W){return t.getContext(T,W)}let et,ht,we,It,Ye,Ke,R,S,Y,he,ce,Te,Me,se,oe,_e,k,le,ae,Re,Se,Ae,Je;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",He,!1),t.addEventListener("webglcontextrestored",st,!1),t.addEventListener("webglcontextcreationerror",O,!1),B===null){let W="webgl2";if(B=De(W,T),B===null)throw De(W)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}it()}catch(T){throw t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",st,!1),t.removeEventListener("webglcontextcreationerror",O,!1),lt("WebGLRenderer: "+T.message),T}function it(){et=new DS(B),et.init(),Se=new m1(B,et),ht=new MS(B,et,e,Se),we=new f1(B,et),ht.reversedDepthBuffer&&h&&we.buffers.depth.setReversed(!0),H=B.createFramebuffer(),P=B.createFramebuffer(),V=B.createFramebuffer(),It=new FS(B),Ye=new Qw,Ke=new p1(B,et,we,Ye,ht,Se,It),R=new LS(I),S=new By(B),Ae=new yS(B,S),Y=new NS(B,S,It,Ae),he=new BS(B,Y,S,Ae,It),le=new OS(B,ht,Ke),oe=new SS(Ye),ce=new jw(I,R,et,ht,Ae,oe),Te=new v1(I,Ye),Me=new t1,se=new a1(et),k=new vS(I,R,we,he,p,c),_e=new d1(I,he,ht),Je=new y1(B,It,ht,we),ae=new bS(B,et,It),Re=new US(B,et,It),It.programs=ce.programs,I.capabilities=ht,I.extensions=et,I.properties=Ye,I.renderLists=Me,I.shadowMap=_e,I.state=we,I.info=It}v!==si&&(U=new zS(v,t.width,t.height,a,s,r));let pe=new xf(I,B);this.xr=pe,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let T=et.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=et.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return Ee},this.setPixelRatio=function(T){T!==void 0&&(Ee=T,this.setSize(be,Pe,!1))},this.getSize=function(T){return T.set(be,Pe)},this.setSize=function(T,W,ne=!0){if(pe.isPresenting){ot("WebGLRenderer: Can't change size while VR device is presenting.");return}be=T,Pe=W,t.width=Math.floor(T*Ee),t.height=Math.floor(W*Ee),ne===!0&&(t.style.width=T+"px",t.style.height=W+"px"),U!==null&&U.setSize(t.width,t.height),this.setViewport(0,0,T,W)},this.getDrawingBufferSize=function(T){return T.set(be*Ee,Pe*Ee).floor()},this.setDrawingBufferSize=function(T,W,ne){be=T,Pe=W,Ee=ne,t.width=Math.floor(T*ne),t.height=Math.floor(W*ne),this.setViewport(0,0,T,W)},this.setEffects=function(T){if(v===si){lt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let W=0;W<T.length;W++)if(T[W].isOutputPass===!0){ot("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}U.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(te)},this.getViewport=function(T){return T.copy(Ge)},this.setViewport=function(T,W,ne,Z){T.isVector4?Ge.set(T.x,T.y,T.z,T.w):Ge.set(T,W,ne,Z),we.viewport(te.copy(Ge).multiplyScalar(kt()).round())},this.getScissor=function(T){return T.copy(ct)},this.setScissor=function(T,W,ne,Z){T.isVector4?ct.set(T.x,T.y,T.z,T.w):ct.set(T,W,ne,Z),we.scissor(ue.copy(ct).multiplyScalar(kt()).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(T){we.setScissorTest(ft=T)},this.setOpaqueSort=function(T){Ve=T},this.setTransparentSort=function(T){Qe=T},this.getClearColor=function(T){return T.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(T=!0,W=!0,ne=!0){let Z=0;if(T){let j=!1;if(re!==null){let Ie=re.texture.format;j=g.has(Ie)}if(j){let Ie=re.texture.type,Ue=m.has(Ie),Le=k.getClearColor(),Fe=k.getClearAlpha(),Ze=Le.r,at=Le.g,yt=Le.b;Ue?(y[0]=Ze,y[1]=at,y[2]=yt,y[3]=Fe,B.clearBufferuiv(B.COLOR,0,y)):(A[0]=Ze,A[1]=at,A[2]=yt,A[3]=Fe,B.clearBufferiv(B.COLOR,0,A))}else Z|=B.COLOR_BUFFER_BIT}W&&(Z|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ne&&(Z|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&B.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),G=T},this.dispose=function(){t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",st,!1),t.removeEventListener("webglcontextcreationerror",O,!1),k.dispose(),Me.dispose(),se.dispose(),Ke.dispose(),Ye.dispose(),R.dispose(),he.dispose(),Y.dispose(),Ae.dispose(),Je.dispose(),ce.dispose(),pe.dispose(),pe.removeEventListener("sessionstart",Tn),pe.removeEventListener("sessionend",zt),Un.stop()};function He(T){T.preventDefault(),tf("WebGLRenderer: Context Lost."),D=!0}function st(){tf("WebGLRenderer: Context Restored."),D=!1;let T=It.autoReset,W=_e.enabled,ne=_e.autoUpdate,Z=_e.needsUpdate,j=_e.type;it(),It.autoReset=T,_e.enabled=W,_e.autoUpdate=ne,_e.needsUpdate=Z,_e.type=j}function O(T){lt("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function ie(T){let W=T.target;W.removeEventListener("dispose",ie),ge(W)}function ge(T){Be(T),Ye.remove(T)}function Be(T){let W=Ye.get(T).programs;W!==void 0&&(W.forEach(function(ne){ce.releaseProgram(ne)}),T.isShaderMaterial&&ce.releaseShaderCache(T))}this.renderBufferDirect=function(T,W,ne,Z,j,Ie){W===null&&(W=Jt);let Ue=j.isMesh&&j.matrixWorld.determinantAffine()<0,Le=Wo(T,W,ne,Z,j);we.setMaterial(Z,Ue);let Fe=ne.index,Ze=1;if(Z.wireframe===!0){if(Fe=Y.getWireframeAttribute(ne),Fe===void 0)return;Ze=2}let at=ne.drawRange,yt=ne.attributes.position,$e=at.start*Ze,bt=(at.start+at.count)*Ze;Ie!==null&&($e=Math.max($e,Ie.start*Ze),bt=Math.min(bt,(Ie.start+Ie.count)*Ze)),Fe!==null?($e=Math.max($e,0),bt=Math.min(bt,Fe.count)):yt!=null&&($e=Math.max($e,0),bt=Math.min(bt,yt.count));let nn=bt-$e;if(nn<0||nn===1/0)return;Ae.setup(j,Z,Le,ne,Fe);let Ft,Ot=ae;if(Fe!==null&&(Ft=S.get(Fe),Ot=Re,Ot.setIndex(Ft)),j.isMesh)Z.wireframe===!0?(we.setLineWidth(Z.wireframeLinewidth*kt()),Ot.setMode(B.LINES)):Ot.setMode(B.TRIANGLES);else if(j.isLine){let _n=Z.linewidth;_n===void 0&&(_n=1),we.setLineWidth(_n*kt()),j.isLineSegments?Ot.setMode(B.LINES):j.isLineLoop?Ot.setMode(B.LINE_LOOP):Ot.setMode(B.LINE_STRIP)}else j.isPoints?Ot.setMode(B.POINTS):j.isSprite&&Ot.setMode(B.TRIANGLES);if(j.isBatchedMesh)if(et.get("WEBGL_multi_draw"))Ot.renderMultiDraw(j._multiDrawStarts,j._multiDrawCounts,j._multiDrawCount);else{let _n=j._multiDrawStarts,We=j._multiDrawCounts,dn=j._multiDrawCount,wt=Fe?S.get(Fe).bytesPerElement:1,cs=Ye.get(Z).currentProgram.getUniforms();for(let fn=0;fn<dn;fn++)cs.setValue(B,"_gl_DrawID",fn),Ot.render(_n[fn]/wt,We[fn])}else if(j.isInstancedMesh)Ot.renderInstances($e,nn,j.count);else if(ne.isInstancedBufferGeometry){let _n=ne._maxInstanceCount!==void 0?ne._maxInstanceCount:1/0,We=Math.min(ne.instanceCount,_n);Ot.renderInstances($e,nn,We)}else Ot.render($e,nn)};function _t(T,W,ne,Z){G!==null&&T.isNodeMaterial&&G.setObject(Z,T),me===!0&&oe.setState(T,ne,!1),T.transparent===!0&&T.side===Ci&&T.forceSinglePass===!1?(T.side=Qn,T.needsUpdate=!0,Yi(T,W,Z),T.side=or,T.needsUpdate=!0,Yi(T,W,Z),T.side=Ci):Yi(T,W,Z)}this.compile=function(T,W,ne=null){ne===null&&(ne=T),G!==null&&G.renderStart(T,W,ne),E=se.get(ne),E.init(W),M.push(E),ne.traverseVisible(function(j){j.isLight&&j.layers.test(W.layers)&&(E.pushLight(j),j.castShadow&&E.pushShadow(j))}),T!==ne&&T.traverseVisible(function(j){j.isLight&&j.layers.test(W.layers)&&(E.pushLight(j),j.castShadow&&E.pushShadow(j))}),E.setupLights(),G!==null&&G.updateLights(E.state.lightsArray),Ne=this.localClippingEnabled,me=oe.init(this.clippingPlanes,Ne),me===!0&&oe.setGlobalState(this.clippingPlanes,W),G!==null&&_e.render(E.state.shadowsArray,ne,W);let Z=new Set;return T.traverse(function(j){if(!(j.isMesh||j.isPoints||j.isLine||j.isSprite))return;let Ie=j.material;if(Ie)if(Array.isArray(Ie))for(let Ue=0;Ue<Ie.length;Ue++){let Le=Ie[Ue];_t(Le,ne,W,j),Z.add(Le)}else _t(Ie,ne,W,j),Z.add(Ie)}),E=M.pop(),G!==null&&G.renderEnd(),Z},this.compileAsync=function(T,W,ne=null){let Z=this.compile(T,W,ne);return new Promise(j=>{function Ie(){if(Z.forEach(function(Ue){let Fe=Ye.get(Ue).currentProgram;(Fe===void 0||Fe.isReady())&&Z.delete(Ue)}),Z.size===0){j(T);return}setTimeout(Ie,10)}et.get("KHR_parallel_shader_compile")!==null?Ie():setTimeout(Ie,10)})};let mt=null;function sn(T){mt&&mt(T)}function Tn(){Un.stop()}function zt(){Un.start()}let Un=new N0;Un.setAnimationLoop(sn),typeof self<"u"&&Un.setContext(self),this.setAnimationLoop=function(T){mt=T,pe.setAnimationLoop(T),T===null?Un.stop():Un.start()},pe.addEventListener("sessionstart",Tn),pe.addEventListener("sessionend",zt),this.render=function(T,W){if(W!==void 0&&W.isCamera!==!0){lt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;G!==null&&G.renderStart(T,W);let ne=pe.enabled===!0&&pe.isPresenting===!0,Z=U!==null&&(re===null||ne)&&U.begin(I,re);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),W.parent===null&&W.matrixWorldAutoUpdate===!0&&W.updateMatrixWorld(),pe.enabled===!0&&pe.isPresenting===!0&&(U===null||U.isCompositing()===!1)&&(pe.cameraAutoUpdate===!0&&pe.updateCamera(W),W=pe.getCamera()),T.isScene===!0&&T.onBeforeRender(I,T,W,re),E=se.get(T,M.length),E.init(W),E.state.textureUnits=Ke.getTextureUnits(),M.push(E),qe.multiplyMatrices(W.projectionMatrix,W.matrixWorldInverse),W.isArrayCamera?ye.setFromArrayCamera(W):tt.setFromProjectionMatrix(qe,Ai,W.reversedDepth),Ne=this.localClippingEnabled,me=oe.init(this.clippingPlanes,Ne),C=Me.get(T,x.length),C.init(),x.push(C),this.info.render.frame++,pe.enabled===!0&&pe.isPresenting===!0){let Ue=I.xr.getDepthSensingMesh();Ue!==null&&Bn(Ue,W,-1/0,I.sortObjects)}Bn(T,W,0,I.sortObjects),C.finish(),G!==null&&G.updateLights(E.state.lightsArray),I.sortObjects===!0&&C.sort(Ve,Qe),Pt=pe.enabled===!1||pe.isPresenting===!1||pe.hasDepthSensing()===!1,Pt&&k.addToRenderList(C,T),this.info.autoReset===!0&&this.info.reset(),me===!0&&oe.beginShadows();let j=E.state.shadowsArray;if(_e.render(j,T,W),me===!0&&oe.endShadows(),(Z&&U.hasRenderPass())===!1){let Ue=C.opaque,Le=C.transmissive;if(E.setupLights(),W.isArrayCamera){let Fe=W.cameras;if(Le.length>0)for(let Ze=0,at=Fe.length;Ze<at;Ze++){let yt=Fe[Ze];Pi(Ue,Le,T,yt)}Pt&&k.render(T);for(let Ze=0,at=Fe.length;Ze<at;Ze++){let yt=Fe[Ze];Rs(C,T,yt,yt.viewport)}}else Le.length>0&&Pi(Ue,Le,T,W),Pt&&k.render(T),Rs(C,T,W)}re!==null&&N===0&&(Ke.updateMultisampleRenderTarget(re),Ke.updateRenderTargetMipmap(re)),Z&&U.end(I),T.isScene===!0&&T.onAfterRender(I,T,W),Ae.resetDefaultState(),q=-1,$=null,M.pop(),M.length>0?(E=M[M.length-1],Ke.setTextureUnits(E.state.textureUnits),me===!0&&oe.setGlobalState(I.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,G!==null&&G.renderEnd()};function Bn(T,W,ne,Z){if(T.visible===!1)return;if(T.layers.test(W.layers)){if(T.isGroup)ne=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(W);else if(T.isLight)E.pushLight(T),T.castShadow&&E.pushShadow(T);else if(T.isSprite){let Ue=W.isArrayCamera?ye:tt;if(!T.frustumCulled||T.intersectsFrustum(Ue)){Z&&ut.setFromMatrixPosition(T.matrixWorld).applyMatrix4(qe);let Le=he.update(T),Fe=T.material;Fe.visible&&C.push(T,Le,Fe,ne,ut.z,null,W)}}else if(T.isMesh||T.isLine||T.isPoints){let Ue=W.isArrayCamera?ye:tt;if(!T.frustumCulled||T.intersectsFrustum(Ue)){let Le=he.update(T),Fe=T.material;if(Z&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),ut.copy(T.boundingSphere.center)):(Le.boundingSphere===null&&Le.computeBoundingSphere(),ut.copy(Le.boundingSphere.center)),ut.applyMatrix4(T.matrixWorld).applyMatrix4(qe)),Array.isArray(Fe)){let Ze=Le.groups;for(let at=0,yt=Ze.length;at<yt;at++){let $e=Ze[at],bt=Fe[$e.materialIndex];bt&&bt.visible&&C.push(T,Le,bt,ne,ut.z,$e,W)}}else Fe.visible&&C.push(T,Le,Fe,ne,ut.z,null,W)}}}let Ie=T.children;for(let Ue=0,Le=Ie.length;Ue<Le;Ue++)Bn(Ie[Ue],W,ne,Z)}function Rs(T,W,ne,Z){let{opaque:j,transmissive:Ie,transparent:Ue}=T;E.setupLightsView(ne),me===!0&&oe.setGlobalState(I.clippingPlanes,ne),Z&&we.viewport(te.copy(Z)),j.length>0&&rn(j,W,ne),Ie.length>0&&rn(Ie,W,ne),Ue.length>0&&rn(Ue,W,ne),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Pi(T,W,ne,Z){if((ne.isScene===!0?ne.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Z.id]===void 0){let $e=et.has("EXT_color_buffer_half_float")||et.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Z.id]=new _i(1,1,{generateMipmaps:!0,type:$e?Hi:si,minFilter:ws,samples:Math.max(4,ht.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Et.workingColorSpace})}let Ie=E.state.transmissionRenderTarget[Z.id],Ue=Z.viewport||te;Ie.setSize(Ue.z*I.transmissionResolutionScale,Ue.w*I.transmissionResolutionScale);let Le=I.getRenderTarget(),Fe=I.getActiveCubeFace(),Ze=I.getActiveMipmapLevel();I.setRenderTarget(Ie),I.getClearColor(K),xe=I.getClearAlpha(),xe<1&&I.setClearColor(16777215,.5),I.clear(),Pt&&k.render(ne);let at=I.toneMapping;I.toneMapping=os;let yt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),E.setupLightsView(Z),me===!0&&oe.setGlobalState(I.clippingPlanes,Z),rn(T,ne,Z),Ke.updateMultisampleRenderTarget(Ie),Ke.updateRenderTargetMipmap(Ie),et.has("WEBGL_multisampled_render_to_texture")===!1){let $e=!1;for(let bt=0,nn=W.length;bt<nn;bt++){let Ft=W[bt],{object:Ot,geometry:_n,material:We,group:dn}=Ft;if(We.side===Ci&&Ot.layers.test(Z.layers)){let wt=We.side;We.side=Qn,We.needsUpdate=!0,un(Ot,ne,Z,_n,We,dn),We.side=wt,We.needsUpdate=!0,$e=!0}}$e===!0&&(Ke.updateMultisampleRenderTarget(Ie),Ke.updateRenderTargetMipmap(Ie))}I.setRenderTarget(Le,Fe,Ze),I.setClearColor(K,xe),yt!==void 0&&(Z.viewport=yt),I.toneMapping=at}function rn(T,W,ne){let Z=W.isScene===!0?W.overrideMaterial:null;for(let j=0,Ie=T.length;j<Ie;j++){let Ue=T[j],{object:Le,geometry:Fe,group:Ze}=Ue,at=Ue.material;at.allowOverride===!0&&Z!==null&&(at=Z),Le.layers.test(ne.layers)&&un(Le,W,ne,Fe,at,Ze)}}function un(T,W,ne,Z,j,Ie){G!==null&&j.isNodeMaterial&&G.setObject(T,j),T.onBeforeRender(I,W,ne,Z,j,Ie),T.modelViewMatrix.multiplyMatrices(ne.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),j.onBeforeRender(I,W,ne,Z,T,Ie),j.transparent===!0&&j.side===Ci&&j.forceSinglePass===!1?(j.side=Qn,j.needsUpdate=!0,I.renderBufferDirect(ne,W,Z,j,T,Ie),j.side=or,j.needsUpdate=!0,I.renderBufferDirect(ne,W,Z,j,T,Ie),j.side=Ci):I.renderBufferDirect(ne,W,Z,j,T,Ie),T.onAfterRender(I,W,ne,Z,j,Ie)}function hn(T){let W=0;for(let ne of T)ne.texture!==null&&W++;return W}function Yi(T,W,ne){W.isScene!==!0&&(W=Jt);let Z=Ye.get(T),j=E.state.lights,Ie=E.state.shadowsArray,Ue=j.state.version,Le=ce.getParameters(T,j.state,Ie,W,ne,E.state.lightProbeGridArray),Fe=ce.getProgramCacheKey(Le),Ze=Z.programs;Z.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?W.environment:null,Z.fog=W.fog;let at=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;Z.envMap=R.get(T.envMap||Z.environment,at),Z.envMapRotation=Z.environment!==null&&T.envMap===null?W.environmentRotation:T.envMapRotation,Ze===void 0&&(T.addEventListener("dispose",ie),Ze=new Map,Z.programs=Ze,Z.programVariants=new Map);let yt=Ze.get(Fe);if(yt!==void 0){if(Z.currentProgram===yt&&Z.lightsStateVersion===Ue)return Ho(T,Le),yt}else Le.uniforms=ce.getUniforms(T),G!==null&&T.isNodeMaterial&&G.build(T,ne,Le),T.onBeforeCompile(Le,I),yt=ce.acquireProgram(Le,Fe),Ze.set(Fe,yt),Z.uniforms=Le.uniforms;let $e=Z.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&($e.clippingPlanes=oe.uniform),Ho(T,Le),Z.needsLights=Ps(T),Z.lightsStateVersion=Ue,Z.needsLights&&($e.ambientLightColor.value=j.state.ambient,$e.lightProbe.value=j.state.probe,$e.sunLights.value=j.state.sun,$e.sunLightShadows.value=j.state.sunShadow,$e.directionalLights.value=j.state.directional,$e.directionalLightShadows.value=j.state.directionalShadow,$e.spotLights.value=j.state.spot,$e.spotLightShadows.value=j.state.spotShadow,$e.rectAreaLights.value=j.state.rectArea,$e.ltc_1.value=j.state.rectAreaLTC1,$e.ltc_2.value=j.state.rectAreaLTC2,$e.pointLights.value=j.state.point,$e.pointLightShadows.value=j.state.pointShadow,$e.hemisphereLights.value=j.state.hemi,$e.sunShadowMatrix.value=j.state.sunShadowMatrix,$e.sunShadowCascade.value=j.state.sunShadowCascade,$e.directionalShadowMatrix.value=j.state.directionalShadowMatrix,$e.spotLightMatrix.value=j.state.spotLightMatrix,$e.spotLightMap.value=j.state.spotLightMap,$e.pointShadowMatrix.value=j.state.pointShadowMatrix),Z.numLightProbeGrids=hn(E.state.lightProbeGridArray),Z.currentProgram=yt,Z.uniformsList=null,yt}function ri(T,W,ne,Z,j){let Ie=Ye.get(T),Ue=Ie.currentProgram.id+","+Z+","+j,Le=Ie.programVariants.get(Ue);return Le===void 0?(Le=Yi(T,W,ne),Ie.programVariants.set(Ue,Le)):(Ie.currentProgram=Le,Ie.uniformsList=null,Ie.outputColorSpace=Z,Ie.toneMapping=j),Le}function Cs(T){if(T.uniformsList===null){let W=T.currentProgram.getUniforms();T.uniformsList=ko.seqWithValue(W.seq,T.uniforms)}return T.uniformsList}function Ho(T,W){let ne=Ye.get(T);ne.outputColorSpace=W.outputColorSpace,ne.batching=W.batching,ne.batchingColor=W.batchingColor,ne.instancing=W.instancing,ne.instancingColor=W.instancingColor,ne.instancingMorph=W.instancingMorph,ne.skinning=W.skinning,ne.morphTargets=W.morphTargets,ne.morphNormals=W.morphNormals,ne.morphColors=W.morphColors,ne.morphTargetsCount=W.morphTargetsCount,ne.numClippingPlanes=W.numClippingPlanes,ne.numIntersection=W.numClipIntersection,ne.vertexAlphas=W.vertexAlphas,ne.vertexTangents=W.vertexTangents,ne.toneMapping=W.toneMapping}function Wo(T,W,ne,Z,j){W.isScene!==!0&&(W=Jt),Ke.resetTextureUnits();let Ie=W.fog,Ue=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?W.environment:null,Le=re===null?I.outputColorSpace:re.isXRRenderTarget===!0?re.texture.colorSpace:Et.workingColorSpace,Fe=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,Ze=R.get(Z.envMap||Ue,Fe),at=Z.vertexColors===!0&&!!ne.attributes.color&&ne.attributes.color.itemSize===4,yt=!!ne.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),$e=!!ne.morphAttributes.position,bt=!!ne.morphAttributes.normal,nn=!!ne.morphAttributes.color,Ft=os;Z.toneMapped&&(re===null||re.isXRRenderTarget===!0)&&(Ft=I.toneMapping);let Ot=ne.morphAttributes.position||ne.morphAttributes.normal||ne.morphAttributes.color,_n=Ot!==void 0?Ot.length:0,We=Ye.get(Z),dn=E.state.lights;if(me===!0&&(Ne===!0||T!==$)){let Bt=T===$&&Z.id===q;oe.setState(Z,T,Bt)}let wt=!1,cs=!1;Z.version===We.__version?We.needsLights&&We.lightsStateVersion!==dn.state.version||j.isBatchedMesh&&We.batching===!1||!j.isBatchedMesh&&We.batching===!0||j.isBatchedMesh&&We.batchingColor===!0&&j._colorsTexture===null||j.isBatchedMesh&&We.batchingColor===!1&&j._colorsTexture!==null||j.isInstancedMesh&&We.instancing===!1||!j.isInstancedMesh&&We.instancing===!0||j.isSkinnedMesh&&We.skinning===!1||!j.isSkinnedMesh&&We.skinning===!0||j.isInstancedMesh&&We.instancingColor===!0&&j.instanceColor===null||j.isInstancedMesh&&We.instancingColor===!1&&j.instanceColor!==null||j.isInstancedMesh&&We.instancingMorph===!0&&j.morphTexture===null||j.isInstancedMesh&&We.instancingMorph===!1&&j.morphTexture!==null||We.envMap!==Ze||Z.fog===!0&&We.fog!==Ie||We.numClippingPlanes!==void 0&&(We.numClippingPlanes!==oe.numPlanes||We.numIntersection!==oe.numIntersection)||We.vertexAlphas!==at||We.vertexTangents!==yt||We.morphTargets!==$e||We.morphNormals!==bt||We.morphColors!==nn||We.morphTargetsCount!==_n||We.numLightProbeGrids!==hn(E.state.lightProbeGridArray)?wt=!0:(We.outputColorSpace!==Le||We.toneMapping!==Ft)&&(cs=!0):(wt=!0,We.__version=Z.version);let fn=We.currentProgram;(wt===!0||cs===!0)&&(fn=cs===!0?ri(Z,W,j,Le,Ft):Yi(Z,W,j),G&&Z.isNodeMaterial&&G.onUpdateProgram(Z,fn,We));let kr=!1,$i=!1,us=!1,gt=fn.getUniforms(),on=We.uniforms;if(we.useProgram(fn.program)&&(kr=!0,$i=!0,us=!0),Z.id!==q&&(q=Z.id,$i=!0),kr||$!==T){we.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),gt.setValue(B,"projectionMatrix",T.projectionMatrix),gt.setValue(B,"viewMatrix",T.matrixWorldInverse);let pn=gt.map.cameraPosition;pn!==void 0&&pn.setValue(B,nt.setFromMatrixPosition(T.matrixWorld)),ht.logarithmicDepthBuffer&&gt.setValue(B,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&gt.setValue(B,"isOrthographic",T.isOrthographicCamera===!0),$!==T&&($=T,$i=!0,us=!0)}if(We.needsLights&&(dn.state.sunShadowMap.length>0&&gt.setValue(B,"sunShadowMap",dn.state.sunShadowMap,Ke),dn.state.directionalShadowMap.length>0&&gt.setValue(B,"directionalShadowMap",dn.state.directionalShadowMap,Ke),dn.state.spotShadowMap.length>0&&gt.setValue(B,"spotShadowMap",dn.state.spotShadowMap,Ke),dn.state.pointShadowMap.length>0&&gt.setValue(B,"pointShadowMap",dn.state.pointShadowMap,Ke)),j.isSkinnedMesh){gt.setOptional(B,j,"bindMatrix"),gt.setOptional(B,j,"bindMatrixInverse");let Bt=j.skeleton;Bt&&(Bt.boneTexture===null&&Bt.computeBoneTexture(),gt.setValue(B,"boneTexture",Bt.boneTexture,Ke))}j.isBatchedMesh&&(gt.setOptional(B,j,"batchingTexture"),gt.setValue(B,"batchingTexture",j._matricesTexture,Ke),gt.setOptional(B,j,"batchingIdTexture"),gt.setValue(B,"batchingIdTexture",j._indirectTexture,Ke),gt.setOptional(B,j,"batchingColorTexture"),j._colorsTexture!==null&&gt.setValue(B,"batchingColorTexture",j._colorsTexture,Ke));let Wn=ne.morphAttributes;if((Wn.position!==void 0||Wn.normal!==void 0||Wn.color!==void 0)&&le.update(j,ne,fn),($i||We.receiveShadow!==j.receiveShadow)&&(We.receiveShadow=j.receiveShadow,gt.setValue(B,"receiveShadow",j.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&W.environment!==null&&(on.envMapIntensity.value=W.environmentIntensity),on.dfgLUT!==void 0&&(on.dfgLUT.value=M1()),$i){if(gt.setValue(B,"toneMappingExposure",I.toneMappingExposure),We.needsLights&&Or(on,us),Ie&&Z.fog===!0&&Te.refreshFogUniforms(on,Ie),Te.refreshMaterialUniforms(on,Z,Ee,Pe,E.state.transmissionRenderTarget[T.id]),We.needsLights&&We.numLightProbeGrids>0){let Bt=b,pn=0;for(let kn of E.state.lightProbeGridArray)kn.texture!==null&&(Bt.textures[pn]=kn.texture,Bt.min[pn]=kn.boundingBox.min,Bt.max[pn]=kn.boundingBox.max,Bt.resolution[pn]=kn.resolution,pn++);for(let kn in Bt)Bt[kn].length=pn;on.probesSH.value=Bt.textures,on.probesMin.value=Bt.min,on.probesMax.value=Bt.max,on.probesResolution.value=Bt.resolution}ko.upload(B,Cs(We),on,Ke)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(ko.upload(B,Cs(We),on,Ke),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&gt.setValue(B,"center",j.center),gt.setValue(B,"modelViewMatrix",j.modelViewMatrix),gt.setValue(B,"normalMatrix",j.normalMatrix),gt.setValue(B,"modelMatrix",j.matrixWorld),Z.uniformsGroups!==void 0){let Bt=Z.uniformsGroups;for(let pn=0,kn=Bt.length;pn<kn;pn++){let ol=Bt[pn];Je.update(ol,fn),Je.bind(ol,fn)}}return fn}function Or(T,W){T.ambientLightColor.needsUpdate=W,T.lightProbe.needsUpdate=W,T.sunLights.needsUpdate=W,T.sunLightShadows.needsUpdate=W,T.directionalLights.needsUpdate=W,T.directionalLightShadows.needsUpdate=W,T.pointLights.needsUpdate=W,T.pointLightShadows.needsUpdate=W,T.spotLights.needsUpdate=W,T.spotLightShadows.needsUpdate=W,T.rectAreaLights.needsUpdate=W,T.hemisphereLights.needsUpdate=W}function Ps(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return z},this.getActiveMipmapLevel=function(){return N},this.getRenderTarget=function(){return re},this.setRenderTargetTextures=function(T,W,ne){let Z=Ye.get(T);Z.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Ye.get(T.texture).__webglTexture=W,Ye.get(T.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:ne,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,W){let ne=Ye.get(T);ne.__webglFramebuffer=W,ne.__useDefaultFramebuffer=W===void 0},this.setRenderTarget=function(T,W=0,ne=0){re=T,z=W,N=ne;let Z=null,j=!1,Ie=!1;if(T){let Le=Ye.get(T);if(Le.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(B.FRAMEBUFFER,Le.__webglFramebuffer),te.copy(T.viewport),ue.copy(T.scissor),de=T.scissorTest,we.viewport(te),we.scissor(ue),we.setScissorTest(de),q=-1;return}else if(Le.__webglFramebuffer===void 0)Ke.setupRenderTarget(T);else if(Le.__hasExternalTextures)Ke.rebindTextures(T,Ye.get(T.texture).__webglTexture,Ye.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let at=T.depthTexture;if(Le.__boundDepthTexture!==at){if(at!==null&&Ye.has(at)&&(T.width!==at.image.width||T.height!==at.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ke.setupDepthRenderbuffer(T)}}let Fe=T.texture;(Fe.isData3DTexture||Fe.isDataArrayTexture||Fe.isCompressedArrayTexture)&&(Ie=!0);let Ze=Ye.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Ze[W])?Z=Ze[W][ne]:Z=Ze[W],j=!0):T.samples>0&&Ke.useMultisampledRTT(T)===!1?Z=Ye.get(T).__webglMultisampledFramebuffer:Array.isArray(Ze)?Z=Ze[ne]:Z=Ze,te.copy(T.viewport),ue.copy(T.scissor),de=T.scissorTest}else te.copy(Ge).multiplyScalar(Ee).floor(),ue.copy(ct).multiplyScalar(Ee).floor(),de=ft;if(ne!==0&&(Z=H),we.bindFramebuffer(B.FRAMEBUFFER,Z)&&we.drawBuffers(T,Z),we.viewport(te),we.scissor(ue),we.setScissorTest(de),j){let Le=Ye.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+W,Le.__webglTexture,ne)}else if(Ie){let Le=W;for(let Fe=0;Fe<T.textures.length;Fe++){let Ze=Ye.get(T.textures[Fe]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Fe,Ze.__webglTexture,ne,Le)}}else if(T!==null&&ne!==0){let Le=Ye.get(T.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Le.__webglTexture,ne)}q=-1};function Br(T){let W=Ye.get(T);return(W.__readFormat!==T.format||W.__readType!==T.type)&&(W.__readFormat=T.format,W.__readType=T.type,W.__formatReadable=ht.textureFormatReadable(T.format),W.__typeReadable=ht.textureTypeReadable(T.type)),W}this.readRenderTargetPixels=function(T,W,ne,Z,j,Ie,Ue,Le=0){if(!(T&&T.isWebGLRenderTarget)){lt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Fe=Ye.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ue!==void 0&&(Fe=Fe[Ue],Array.isArray(Fe)&&(Fe=Fe[0])),Fe){we.bindFramebuffer(B.FRAMEBUFFER,Fe);try{let Ze=T.textures[Le],at=Ze.format,yt=Ze.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Le);let $e=Br(Ze);if($e.__formatReadable===!1){lt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if($e.__typeReadable===!1){lt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}W>=0&&W<=T.width-Z&&ne>=0&&ne<=T.height-j&&B.readPixels(W,ne,Z,j,Se.convert(at),Se.convert(yt),Ie)}finally{let Ze=re!==null?Ye.get(re).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,Ze)}}},this.readRenderTargetPixelsAsync=async function(T,W,ne,Z,j,Ie,Ue,Le=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Fe=Ye.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ue!==void 0&&(Fe=Fe[Ue],Array.isArray(Fe)&&(Fe=Fe[0])),Fe)if(W>=0&&W<=T.width-Z&&ne>=0&&ne<=T.height-j){we.bindFramebuffer(B.FRAMEBUFFER,Fe);let Ze=T.textures[Le],at=Ze.format,yt=Ze.type;T.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Le);let $e=Br(Ze);if($e.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if($e.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let bt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,bt),B.bufferData(B.PIXEL_PACK_BUFFER,Ie.byteLength,B.STREAM_READ),B.readPixels(W,ne,Z,j,Se.convert(at),Se.convert(yt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let nn=re!==null?Ye.get(re).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,nn);let Ft=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await o0(B,Ft,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,bt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ie),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(bt),B.deleteSync(Ft),Ie}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,W=null,ne=0){let Z=Math.pow(2,-ne),j=Math.floor(T.image.width*Z),Ie=Math.floor(T.image.height*Z),Ue=W!==null?W.x:0,Le=W!==null?W.y:0;Ke.setTexture2D(T,0),B.copyTexSubImage2D(B.TEXTURE_2D,ne,0,0,Ue,Le,j,Ie),we.unbindTexture()},this.copyTextureToTexture=function(T,W,ne=null,Z=null,j=0,Ie=0){let Ue,Le,Fe,Ze,at,yt,$e,bt,nn,Ft=T.isCompressedTexture?T.mipmaps[Ie]:T.image;if(ne!==null)Ue=ne.max.x-ne.min.x,Le=ne.max.y-ne.min.y,Fe=ne.isBox3?ne.max.z-ne.min.z:1,Ze=ne.min.x,at=ne.min.y,yt=ne.isBox3?ne.min.z:0;else{let gt=Math.pow(2,-j);Ue=Math.floor(Ft.width*gt),Le=Math.floor(Ft.height*gt),T.isDataArrayTexture?Fe=Ft.depth:T.isData3DTexture?Fe=Math.floor(Ft.depth*gt):Fe=1,Ze=0,at=0,yt=0}Z!==null?($e=Z.x,bt=Z.y,nn=Z.z):($e=0,bt=0,nn=0);let Ot=Se.convert(W.format),_n=Se.convert(W.type),We;W.isData3DTexture?(Ke.setTexture3D(W,0),We=B.TEXTURE_3D):W.isDataArrayTexture||W.isCompressedArrayTexture?(Ke.setTexture2DArray(W,0),We=B.TEXTURE_2D_ARRAY):(Ke.setTexture2D(W,0),We=B.TEXTURE_2D),we.activeTexture(B.TEXTURE0),we.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,W.flipY),we.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,W.premultiplyAlpha),we.pixelStorei(B.UNPACK_ALIGNMENT,W.unpackAlignment);let dn=we.getParameter(B.UNPACK_ROW_LENGTH),wt=we.getParameter(B.UNPACK_IMAGE_HEIGHT),cs=we.getParameter(B.UNPACK_SKIP_PIXELS),fn=we.getParameter(B.UNPACK_SKIP_ROWS),kr=we.getParameter(B.UNPACK_SKIP_IMAGES);we.pixelStorei(B.UNPACK_ROW_LENGTH,Ft.width),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Ft.height),we.pixelStorei(B.UNPACK_SKIP_PIXELS,Ze),we.pixelStorei(B.UNPACK_SKIP_ROWS,at),we.pixelStorei(B.UNPACK_SKIP_IMAGES,yt);let $i=T.isDataArrayTexture||T.isData3DTexture,us=W.isDataArrayTexture||W.isData3DTexture;if(T.isDepthTexture){let gt=Ye.get(T),on=Ye.get(W),Wn=Ye.get(gt.__renderTarget),Bt=Ye.get(on.__renderTarget);we.bindFramebuffer(B.READ_FRAMEBUFFER,Wn.__webglFramebuffer),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,Bt.__webglFramebuffer);for(let pn=0;pn<Fe;pn++)$i&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ye.get(T).__webglTexture,j,yt+pn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ye.get(W).__webglTexture,Ie,nn+pn)),B.blitFramebuffer(Ze,at,Ze+Ue,at+Le,$e,bt,$e+Ue,bt+Le,B.DEPTH_BUFFER_BIT,B.NEAREST);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(j!==0||T.isRenderTargetTexture||Ye.has(T)){let gt=Ye.get(T),on=Ye.get(W);we.bindFramebuffer(B.READ_FRAMEBUFFER,P),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,V);for(let Wn=0;Wn<Fe;Wn++)$i?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,gt.__webglTexture,j,yt+Wn):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,gt.__webglTexture,j),us?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,on.__webglTexture,Ie,nn+Wn):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,on.__webglTexture,Ie),j!==0?B.blitFramebuffer(Ze,at,Ze+Ue,at+Le,$e,bt,$e+Ue,bt+Le,B.COLOR_BUFFER_BIT,B.NEAREST):us?B.copyTexSubImage3D(We,Ie,$e,bt,nn+Wn,Ze,at,Ue,Le):B.copyTexSubImage2D(We,Ie,$e,bt,Ze,at,Ue,Le);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else us?T.isDataTexture||T.isData3DTexture?B.texSubImage3D(We,Ie,$e,bt,nn,Ue,Le,Fe,Ot,_n,Ft.data):W.isCompressedArrayTexture?B.compressedTexSubImage3D(We,Ie,$e,bt,nn,Ue,Le,Fe,Ot,Ft.data):B.texSubImage3D(We,Ie,$e,bt,nn,Ue,Le,Fe,Ot,_n,Ft):T.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ie,$e,bt,Ue,Le,Ot,_n,Ft.data):T.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ie,$e,bt,Ft.width,Ft.height,Ot,Ft.data):B.texSubImage2D(B.TEXTURE_2D,Ie,$e,bt,Ue,Le,Ot,_n,Ft);we.pixelStorei(B.UNPACK_ROW_LENGTH,dn),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,wt),we.pixelStorei(B.UNPACK_SKIP_PIXELS,cs),we.pixelStorei(B.UNPACK_SKIP_ROWS,fn),we.pixelStorei(B.UNPACK_SKIP_IMAGES,kr),Ie===0&&W.generateMipmaps===!0&&W.mipmapsAutoUpdate===!0&&B.generateMipmap(We),we.unbindTexture()},this.initRenderTarget=function(T){Ye.get(T).__webglFramebuffer===void 0&&Ke.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?Ke.setTextureCube(T,0):T.isData3DTexture?Ke.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?Ke.setTexture2DArray(T,0):Ke.setTexture2D(T,0),we.unbindTexture()},this.resetState=function(){z=0,N=0,re=null,we.reset(),Ae.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ai}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Et._getDrawingBufferColorSpace(e),t.unpackColorSpace=Et._getUnpackColorSpace()}};function q0(i,e=!1){let t=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,c=new vi;c.morphTargetsRelative=a;let l=0;for(let u=0;u<i.length;++u){let d=i[u],h=0,f=0;if(t!==(d.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in d.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(d.attributes[p]),h++}if(h!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==d.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in d.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(d.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(d.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(e){let p;if(t)p=d.index.count;else if(d.attributes.position!==void 0)p=d.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;c.addGroup(l,p,u),l+=p}}if(t){let u=0,d=[];for(let h=0;h<i.length;++h){let f=i[h].index;for(let p=0;p<f.count;++p)d.push(f.getX(p)+u);u+=i[h].attributes.position.count}c.setIndex(d)}for(let u in r){let d=X0(r[u]);if(!d)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;c.setAttribute(u,d)}for(let u in o){let d=o[u][0].length;if(d!==0){c.morphAttributes=c.morphAttributes||{},c.morphAttributes[u]=[];for(let h=0;h<d;++h){let f=[];for(let v=0;v<o[u].length;++v)f.push(o[u][v][h]);let p=X0(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;c.morphAttributes[u].push(p)}}}return c}function X0(i){let e,t,n,s=-1,r=0;for(let l=0;l<i.length;++l){let u=i[l];if(e===void 0&&(e=u.array.constructor),e!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(t===void 0&&(t=u.itemSize),t!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=u.normalized),n!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*t}let o=new e(r),a=new Ri(o,t,n),c=0;for(let l=0;l<i.length;++l){let u=i[l];if(u.isInterleavedBufferAttribute){let d=c/t;for(let h=0,f=u.count;h<f;h++)for(let p=0;p<t;p++){let v=u.getComponent(h,p);a.setComponent(h+d,p,v)}}else o.set(u.array,c);c+=u.count*t}return s!==void 0&&(a.gpuType=s),a}var sl=-.7,Y0=-.23,Z0=[.25,-.4,2.4],$0=1,vf=.1,S1=.62,w1=4,T1=46,Go="#8f9aa8",As="#39424e",E1="#b08d57",yf=class{constructor(e,t,n){this.canvas=e;this.renderer=new Eu({canvas:e,antialias:!0,alpha:!0}),this.renderer.setScissorTest(!0),this.accent=new Do,this.arrows=new ss;let s=new Wa("#ffffff",2.4);s.position.set(...Z0),this.scene.add(new Ga("#ffffff","#aab4c2",1.9),s,this.floor,A1()),this.setRig(t,n),this.camera.up.set(0,0,1),this.orbitByDragging(),this.orbitByKeys(),this.paint(),Us(()=>this.paint())}canvas;renderer;scene=new Ca;camera=new Jn(30,1,.1,20);body;ghost;shadow;rig=null;parameters;floor=P1();shade=new ss;haze=new ss({transparent:!0,opacity:.25,depthWrite:!1});accent;arrows;fits=!1;places=new Map;resized=new ResizeObserver(()=>{this.places.clear(),this.fits=!1,this.moved=!0});centres=new Map;centre=new ee;spins=new Map;moved=!0;azimuth=-.62;height=.42;setRig(e,t){if(this.parameters=t,e===this.rig)return;this.rig=e;let n=this.body?[this.body.travel,this.ghost.travel,this.shadow.travel.parent]:[];for(let s of n)this.scene.remove(s),s.traverse(r=>r instanceof Nn&&r.geometry.dispose());this.body=R1(e,this.accent,this.arrows),this.ghost=Q0(e,this.haze),this.shadow=C1(e,this.shade),this.scene.add(this.body.travel,this.ghost.travel,this.shadow.travel.parent),this.moved=!0}paint(){this.floor.material.color.set(ci("floor")),this.shade.color.set(ci("shadow")),this.haze.color.set(ci("ghost")),this.moved=!0}draw(e,t){let{renderer:n,canvas:s,camera:r}=this;this.moved=!1,this.fits||(n.setPixelRatio(Math.min(window.devicePixelRatio,2)),n.setSize(s.clientWidth,s.clientHeight,!1),this.fits=!0),this.centres.clear();for(let o of e){let{left:a,bottom:c,width:l,height:u}=this.placeOf(o.element);n.setViewport(a,c,l,u),n.setScissor(a,c,l,u);let d=l/u,h=3.45*Math.max(1,1.12/d);r.aspect=d,r.position.set(h*Math.cos(this.height)*Math.cos(this.azimuth),h*Math.cos(this.height)*Math.sin(this.azimuth),h*Math.sin(this.height)+Y0),r.lookAt(0,0,Y0),r.updateProjectionMatrix(),this.place(o,t),n.render(this.scene,r);let f=this.centre.setFromMatrixPosition(this.body.pitch.matrixWorld).project(r),p=s.clientHeight-c-u;this.centres.set(o.element,[a+(.5+.5*f.x)*l,p+(.5-.5*f.y)*u])}}placeOf(e){let t=this.places.get(e);if(t)return t;this.resized.observe(e);let n=this.canvas.getBoundingClientRect(),s=e.getBoundingClientRect(),r={left:s.left-n.left,bottom:n.bottom-s.bottom,width:s.width,height:s.height};return this.places.set(e,r),r}place({element:e,colour:t,x:n,u:s,ghost:r},o){this.accent.color.set(t),this.arrows.color.set(t),_f(this.body,n),_f(this.shadow,n),this.ghost.travel.visible=r!==null,r&&_f(this.ghost,r);let a=this.spins.get(e)??[0,0];this.spins.set(e,a);let c=ni(s,this.parameters);this.body.rotors.forEach(({blades:l,blur:u,arrow:d},h)=>{let f=c[h];a[h]+=(h?-1:1)*w1*s[h]*o,l.rotation.z=a[h],u.material.opacity=Math.min(.75*Math.abs(f),.6);let p=Math.max(S1*Math.abs(f),.001);d.scale.set(1,1,f<0?-1:1);let[v,g]=d.children,m=Math.min(.07,.6*p);v.scale.z=p-m,g.scale.setScalar(m),g.position.z=p-.5*m})}orbit(e,t){this.moved=!0,this.azimuth+=e,this.height=Math.min(Math.max(this.height+t,.05),1.45)}orbitByKeys(){let e={ArrowLeft:[.1,0],ArrowRight:[-.1,0],ArrowUp:[0,.1],ArrowDown:[0,-.1]};this.canvas.addEventListener("keydown",t=>{let n=e[t.key];!n||t.ctrlKey||t.metaKey||t.altKey||(this.orbit(...n),t.preventDefault())})}onBodyDrag=null;orbitByDragging(){let e=this.canvas.parentElement;this.resized.observe(e);let t=null;e.addEventListener("pointerdown",s=>{!this.onBodyDrag||!this.hitsBody(s)||(t={x:s.clientX,y:s.clientY},e.setPointerCapture(s.pointerId),e.classList.add("pushing"))});let n=()=>{t=null,this.onBodyDrag?.(0,0),e.classList.remove("pushing")};e.addEventListener("pointerup",n),e.addEventListener("pointercancel",n),e.addEventListener("pointermove",s=>{s.buttons!==0&&(t?this.onBodyDrag?.(s.clientX-t.x,s.clientY-t.y):this.orbit(-.008*s.movementX,.005*s.movementY))})}hitsBody({clientX:e,clientY:t}){let n=this.canvas.getBoundingClientRect();return[...this.centres.values()].some(([s,r])=>Math.hypot(e-n.left-s,t-n.top-r)<T1)}};function Iu(i,e,t){try{return new yf(i,e,t)}catch{return i.parentElement.dataset.message="The 3D view needs WebGL, which this browser does not offer.",null}}function _f({travel:i,elevation:e,pitch:t},n){i.rotation.z=n[0],e.rotation.y=n[2],t.rotation.x=n[4]}function Cu(i,e){for(let[t,n]of i){let{r:s,g:r,b:o}=new vt(n),a=t.getAttribute("position").count;t.setAttribute("color",new en(Array.from({length:a},()=>[s,r,o]).flat(),3))}return new Nn(q0(i.map(([t])=>t)),e)}function Xi(i,e,t,n=0,s=0,r=0){let o=new Lo(e,e,i,24);return t==="x"&&o.rotateZ(Math.PI/2),t==="z"&&o.rotateX(Math.PI/2),o.translate(n,s,r)}var bf=(i,e,t,n=0,s=0,r=0)=>new nr(i,e,t).translate(n,s,r),J0=()=>new Do({vertexColors:!0});function A1(){return Cu([[Xi(.03,.17,"z",0,0,sl+.015),As],[Xi(-sl-.04,.024,"z",0,0,sl/2-.02),Go],[Xi(.05,.045,"z",0,0,-.07),As]],J0())}function K0({l_h:i,l_p:e,l_c:t,d_c:n}){let s=[.028,-.028].map(a=>[bf(.05,.012,.09,0,a,-.012),As]),r=[[Xi(.07,.008,"y"),Go],[Xi(i+t-.02,.011,"x",(i-t)/2),Go],[Xi(n,.007,"z",-t,0,-n/2),Go],[Xi(.1,.06,"x",-t,0,-n),E1]],o=[[Xi(2*e,.009,"y"),As],[bf(.06,.09,.03),As],[Xi(.05,.014,"x"),Go],...[e,-e].map(a=>[Xi(.045,.016,"z",0,a,.01),As])];return[s,r,o]}var Pu=i=>new Ba(vf,.006,10,48).translate(0,i,.03);function j0(i,[e,t,n]){let[s,r,o]=[new xi,new xi,new xi];return s.add(e,r),r.add(t,o),o.add(n),o.position.set(i.l_h,0,i.e_h),{travel:s,elevation:r,pitch:o}}function R1(i,e,t){let n=J0(),[s,r,o]=K0(i);o.push([Pu(-i.l_p),Go]);let a=j0(i,[s,r,o].map(u=>Cu(u,n))),c=new Nn(Pu(i.l_p),e);a.pitch.add(c);let l=[i.l_p,-i.l_p].map(u=>{let d=Cu([[bf(2*vf-.03,.018,.003),As]],n);d.position.set(0,u,.034);let h=new ss({color:"#5b6675",transparent:!0,depthWrite:!1,side:Ci});h.forceSinglePass=!0;let f=new Nn(new Io(vf-.008,40),h);f.position.set(0,u,.032);let p=new xi;return p.position.set(0,u,.04),p.add(new Nn(Xi(1,.009,"z",0,0,.5),t),new Nn(new Fa(.4,1,20).rotateX(Math.PI/2),t)),a.pitch.add(d,f,p),{blades:d,blur:f,arrow:p}});return{...a,rotors:l}}function Q0(i,e){let[t,n,s]=K0(i);return s.push([Pu(i.l_p),As],[Pu(-i.l_p),As]),j0(i,[t,n,s].map(r=>Cu(r,e)))}function C1(i,e){let t=Q0(i,e),[n,s,r]=Z0,[o,a,c]=[sl+.003,-n/r,-s/r],l=new xi;return l.matrixAutoUpdate=!1,l.matrix.set(1,0,a,-a*o,0,1,c,-c*o,0,0,0,o,0,0,0,1),l.add(t.travel),t}function P1(){let i=document.createElement("canvas"),e=1536;i.width=i.height=e;let t=i.getContext("2d"),n=e/2/$0;t.fillStyle="#e3e8ef",t.fillRect(0,0,e,e),t.translate(e/2,e/2),t.strokeStyle="#aab5c2",t.fillStyle="#6b7786",t.lineWidth=.008*n,t.beginPath(),t.arc(0,0,.66*n,0,2*Math.PI),t.stroke(),t.font=`600 ${.09*n}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";for(let o=0;o<360;o+=15){t.save(),t.rotate(-o*Math.PI/180);let a=o%90===0;t.beginPath(),t.moveTo((a?.72:.76)*n,0),t.lineTo(.8*n,0),t.stroke(),a&&(t.translate(.9*n,0),t.rotate(-Math.PI/2),t.fillText(`${o}\xB0`,0,0)),t.restore()}let s=new Da(i);s.colorSpace=Zn,s.anisotropy=8;let r=new Nn(new Io($0,96),new ss({map:s}));return r.position.z=sl,r}var ex=2,I1=30,wn="feedforward+tvlqr",L1=.95,Lu=({experiment:i,flights:e},t)=>t in e&&i.endError(e[t])<=ex,qi=i=>i.filter(({wasPushed:e,experiment:t})=>!e&&!t.log),Mf=({experiment:i,flights:e},t)=>{let n=i.rmsError(e[t]);return Number.isFinite(n)?`${Pn(n,2)}\xB0`:"no arrival"},D1=({experiment:i},e)=>`${(Gs(i.setup,e)??Number.NaN).toFixed(2)} s`;function N1({experiment:i},e,t){let{setup:n}=i,s=Gs(n,t);for(let r of _r(vn(t,n.rig),n.method).durations){let o={...n,duration:r},a=Gs(o,t);if(a===null||a>=s)continue;let c=jr.make(o,t),l=c?.fly(e);if(c&&l&&c.endError(l)<=ex)return!1}return!0}function tx({experiment:i}){let e=la(i.plant),t=Bs.filter(n=>Math.abs(e[n])>1e-9);return i.setup.startOff>0?[...t,"start"]:t}var Sf=i=>new Set(qi(i).filter(e=>"open-loop"in e.flights&&e.experiment.endError(e.flights["open-loop"])>I1).map(tx).filter(e=>e.length===1).flat()),wf=i=>{let e=qi(i).filter(({flights:t})=>wn in t);return e.flatMap(t=>e.flatMap(n=>{let[s,r]=[t.experiment.setup,n.experiment.setup];return JSON.stringify({...s,window:0,method:0})===JSON.stringify({...r,window:0,method:0})&&r.window[0]>s.window[0]&&r.window[1]<s.window[1]?[[t,n]]:[]}))},Du=[{id:"fastest",title:"Find the fastest plan that arrives on lab",text:"The fastest plan uses all of the voltage, and a real plant has lag, friction and weaker rotors. Shorten and lengthen the plan: which is the fastest that still ends within 2\xB0 of the goal with the paper's controller?",setup:{method:"spline",duration:10,pitchLimit:50,window:[0,12],plant:"lab",draw:1,startOff:3},policies:[wn],goals:[{text:"Fly a plan that arrives",isReached:i=>qi(i).some(e=>Lu(e,wn))},{text:"Fly one that does not",isReached:i=>qi(i).some(e=>wn in e.flights&&!Lu(e,wn))},{text:"Fly the fastest that arrives",isReached:(i,e)=>qi(i).some(t=>t.experiment.setup.plant==="lab"&&Lu(t,wn)&&N1(t,wn,e))}],report:(i,e)=>qi(i).slice(-4).map(t=>`${D1(t,e)}: ${Pn(t.experiment.endError(t.flights[wn]),1)}\xB0 off at the end`).join("; "),lesson:"The plan must leave something to the feedback. How much depends on the plant: try another draw."},{id:"open-loop",title:"Why does the open loop fail?",text:"The plan is exact for equation (3). See that its voltages alone arrive on the nominal plant from the right start. Then change one thing only, and find two different things, each of which alone takes the open loop more than 30\xB0 off.",setup:{method:"paper",duration:10,pitchLimit:50,window:[1,11],plant:"nominal",startOff:0},policies:["open-loop"],goals:[{text:"Open loop on the nominal plant from the right start: it arrives",isReached:i=>qi(i).some(e=>tx(e).length===0&&Lu(e,"open-loop"))},{text:"One thing alone makes it miss",isReached:i=>Sf(i).size>=1},{text:"A second one does too",isReached:i=>Sf(i).size>=2}],report:i=>{let e=[...Sf(i)];return e.length?`Alone enough: ${e.join(", ")}.`:""},lesson:"Nothing pulls the travel back: an acceleration that is slightly wrong is integrated twice. Feedback (51) closes that gap."},{id:"reserve",title:"What does the reserve buy?",text:"Plan twice with the same duration: once with all of the voltage (0 to 12 V), once with a reserve (1 to 11 V). Fly both on lab with the paper's controller, and compare the errors.",setup:{method:"spline",duration:8.5,pitchLimit:50,window:[0,12],plant:"lab",draw:1,startOff:3},policies:[wn],goals:[{text:"Fly a plan without reserve",isReached:i=>qi(i).some(({experiment:e,flights:t})=>wn in t&&e.setup.window.join()===e.rig.amplifier.join())},{text:"Fly one with a reserve, all else equal",isReached:i=>wf(i).length>0},{text:"Find a duration at which the reserve changes the error by more than a tenth",isReached:i=>wf(i).some(([e,t])=>{let[n,s]=[e,t].map(({experiment:r,flights:o})=>r.rmsError(o[wn]));return Math.abs(n-s)>.1*Math.min(n,s)})}],report:i=>wf(i).slice(-2).map(([e,t])=>[e,t].map(n=>{let{experiment:s,flights:r}=n;return`${s.setup.window.join(" to ")} V: ${Mf(n,wn)} RMS, ${Pn(100*s.saturation(r[wn]),0)} % of the time at the amplifier's limits`}).join("; ")).join(". "),lesson:"A plan inside its limits leaves voltage to the feedback, which would otherwise saturate. The price is a longer fastest plan."},{id:"weights",title:"Beat the paper's controller with your weights",text:"Both fly the same feedforward. Change the weights of (49), and track travel and elevation on lab with an RMS error at least 5 % smaller than that of the paper's controller.",setup:{method:"paper",duration:10,pitchLimit:50,window:[1,11],plant:"lab",draw:1,startOff:3},policies:[wn,"yours"],goals:[{text:"Fly your weights next to the paper's",isReached:i=>qi(i).some(({flights:e,experiment:t})=>wn in e&&"yours"in e&&Object.values(t.setup.weights).some(n=>n!==0))},{text:"Error at least 5 % smaller",isReached:i=>qi(i).some(({flights:e,experiment:t})=>wn in e&&"yours"in e&&t.setup.plant==="lab"&&t.rmsError(e.yours)<L1*t.rmsError(e[wn]))}],report:i=>qi(i).filter(({flights:e})=>wn in e&&"yours"in e).slice(-3).map(e=>`yours ${Mf(e,"yours")}, the paper's ${Mf(e,wn)}`).join("; "),lesson:"Stiffer is better only until lag and delay answer: more weight on travel makes the pitch swing. The gains are below."}],Nu=class{constructor(e,t){this.data=e;let n=Du.map((s,r)=>{this.goals.push(s.goals.map(({text:l})=>J("li",{},l))),this.notes.push({report:J("p",{class:"small"}),lesson:J("p",{class:"lesson",hidden:!0},s.lesson)});let o=J("button",{"data-task":s.id,click:()=>{this.active=r,this.seen[r]=[],t(s)}},"set it up"),{report:a,lesson:c}=this.notes[r];return J("details",{class:"task",name:"task"},J("summary",{},s.title),J("p",{class:"small"},s.text),o,J("ul",{class:"goals"},...this.goals[r]),J("div",{role:"status"},a,c))});this.element=J("div",{class:"tasks"},...n)}data;element;goals=[];notes=[];seen=Du.map(()=>[]);reached=Du.map(({goals:e})=>e.map(()=>!1));active=-1;complete(e){if(this.active<0)return;let[t,n]=[Du[this.active],this.active];this.seen[n].push(e),t.goals.forEach(({isReached:s},r)=>{this.reached[n][r]||=s(this.seen[n],this.data),this.goals[n][r].classList.toggle("done",this.reached[n][r])}),this.notes[n].report.textContent=t.report(this.seen[n],this.data),this.notes[n].lesson.hidden=!this.reached[n].every(Boolean)}};var U1=[.25,.5,1,2,4],F1=.1,nx=[{label:"\u25C0 pitch",key:"ArrowLeft",axis:2,acceleration:-6},{label:"pitch \u25B6",key:"ArrowRight",axis:2,acceleration:6},{label:"\u25B2 lift",key:"ArrowUp",axis:1,acceleration:-3},{label:"\u25BC press",key:"ArrowDown",axis:1,acceleration:3}],Tf={perPixel:.05,most:8},ix=["1","2","3","4"],sx=["5","6","7","8","9","0"],O1={nominal:"Equation (3), exactly: what the controllers assume.",lab:"(3) with rotor lag, friction, thrust loss, a delay, and encoders.",rigid:"The full rigid body, with the rotors, friction and encoders of lab.",fleet:"Rigs of measured flights: uneven rotors, drifting thrust, wrong sensor zeros, a table."};function ax(i,e){let t=i.control_period,n=i.policies.map(({colour:O})=>O),s=bh(location.hash,i),r=s.setup,o=i.policies.map(({name:O})=>s.shown.includes(O)),a=null,c=null,l=[],u=[],d=[0,0],h=0,f=!1,p=!0,v=1,g=i.policies.map(({label:O},ie)=>new $r(O,n[ie],ie)),m=J("canvas",{tabindex:0,role:"application","aria-label":"helicopters in 3D: drag or use the arrow keys to look from elsewhere, drag a body to push it; the numbers are below each"}),y=J("div",{class:"stage"},m,...g.map(O=>O.element)),A=new Yr,b=i.policies.map(({label:O},ie)=>({label:O,colour:n[ie],mark:ie})),C={label:"plan",colour:"",dashed:!0},E=[],x=O=>{oe(!1),h=Math.min(Math.max(O,0),R()),se(),p=!0},M=(O,ie)=>{let ge=new Xs({...O,duration:1,onTime:x});return E.push({plot:ge,...ie}),ge},U=(O,ie,ge="deg")=>M({title:O,unit:ge,lines:[...b,C],...ie===4&&{limits:[0,0]}},{value:Be=>Vt(Be[ie]),planned:!0}),I=b.map(O=>({...O,held:!0})),D=(O,ie)=>M({title:O,unit:"V",lines:[...I,C],limits:[0,0],range:[0,12]},{value:(ge,Be)=>Be[ie],planned:!0});U("travel",0),U("elevation",2,"deg, positive down");let G=U("pitch",4),H=[D("front voltage",0),D("back voltage",1)];M({title:"travel error",unit:"deg",lines:b,range:[-.1,.1]},{value:(O,ie,ge)=>Vt(O[0]-a.reference.x[ge][0])});let P=new Ul(i.policies,t,b,x),V=[],z=(O,ie,ge,Be)=>{let _t=J("input",{type:"range",id:O}),mt=J("output",{for:O}),sn=()=>{let{min:Tn,max:zt,step:Un,value:Bn,text:Rs}=ge();Object.assign(_t,{min:`${Tn}`,max:`${zt}`,step:`${Un}`}),_t.value=`${Bn}`,_t.setAttribute("aria-valuetext",Rs),mt.textContent=Rs};return _t.addEventListener("input",()=>{Be(Number(_t.value)),he()}),V.push(sn),J("div",{class:"slider"},J("label",{for:O},ie),mt,_t)},N=()=>_r(vn(i,r.rig),r.method),re=()=>({...gl(r,N()),startOff:r.startOff}),q={duration:()=>{let O=Gs(r,i);return r.duration===null?`fastest${O===null?"":`, ${O.toFixed(2)} s`}`:`${r.duration.toFixed(1)} s`},pitch:()=>`\xB1${r.pitchLimit}\xB0`,window:()=>`${rx(r.window[0])} to ${rx(r.window[1])} V`,startOff:()=>`${r.startOff}\xB0`},$=(O,ie,ge,Be)=>z(O,ie,()=>({min:0,max:ge()-1,step:1,value:re()[O],text:q[O]()}),Be),te=O=>r={...r,...O},ue=J("select",{id:"rig"},...i.rigs.map(({name:O})=>J("option",{value:O},O))),de=J("p",{class:"small"});ue.addEventListener("change",()=>{let O=xr(i,vn(i,ue.value));r=zs({...O,startOff:r.startOff,plant:r.plant,draw:r.draw,weights:r.weights},i),c=null,he()});let K=J("select",{id:"method"},J("option",{value:"paper"},"the paper's method, (38)"),J("option",{value:"spline"},"splines, smoothest"));K.addEventListener("change",()=>{r=zs({...r,method:K.value},i),he()});let xe=J("p",{class:"message",role:"status",hidden:!0}),be=J("button",{id:"remedy",hidden:!0,click:()=>{let O=Y("spline");O&&(r=O),he()}}),Pe=J("button",{click:()=>{r={...r,...Ee()},he()}},"the paper's values"),Ee=()=>{let{method:O,duration:ie,pitchLimit:ge,window:Be}=xr(i,vn(i,r.rig));return{method:O,duration:ie,pitchLimit:ge,window:Be}},Ve=i.policies.map(({label:O},ie)=>{let ge=J("input",{type:"checkbox",id:`policy-${ie}`});return ge.addEventListener("change",()=>le(ie,ge.checked)),{box:ge,label:J("label",{},ge,ei(ie,n[ie]),O)}}),Qe=J("p",{class:"small",role:"status",id:"plant-note"}),Ge=J("button",{click:()=>Se()},"another draw"),ct=J("div",{class:"segments",role:"radiogroup","aria-label":"plant"}),ft=Bs.map(O=>{let{name:ie,unit:ge,digits:Be,max:_t,step:mt}=gr[O],sn=O==="zero"?gr.zero.min:0,Tn=()=>la(_l(r,i).plant)[O];return z(O,ie,()=>({min:sn,max:_t,step:mt,value:Tn(),text:`${Pn(Tn(),Be)} ${ge}`}),zt=>te({effects:{...r.effects,[O]:zt}}))}),tt=J("button",{click:()=>{te({effects:{}}),he()}},"as drawn"),ye=ks.map(O=>z(`weight-${O}`,O==="effort"?"effort (R)":`${O} (Q)`,()=>({min:-2,max:2,step:.25,value:r.weights[O],text:`\xD7 ${Number((10**r.weights[O]).toPrecision(2))}`}),ie=>{te({weights:{...r.weights,[O]:ie}}),o[i.policies.findIndex(ge=>ge.name==="yours")]=!0})),me=new Nu(i,O=>{let ie=xr(i,i.rigs[0]);r=zs({...ie,...O.setup},i),i.policies.forEach(({name:ge},Be)=>o[Be]=O.policies.includes(ge)),c=null,he()}),Ne=J("button",{class:"primary",id:"play",click:()=>oe(!f)}),qe=J("button",{click:()=>Me()},"Restart"),nt=J("select",{"aria-label":"speed",id:"speed"},...U1.map(O=>J("option",{value:O,selected:O===1},`${O}\xD7`)));nt.addEventListener("change",()=>v=Number(nt.value));let ut=J("output",{class:"clock"}),Jt=nx.map(O=>J("button",{class:"push",click:()=>k(O.axis,O.acceleration)},O.label)),Pt=J("p",{class:"small",role:"status"}),kt=J("input",{type:"file",accept:".csv,text/csv",id:"log",class:"hidden-file"});kt.addEventListener("change",()=>kt.files?.[0]&&Ae(kt.files[0]));let B=J("button",{hidden:!0,click:()=>{c=null,he()}},"back to the plan"),De=J("button",{click:async()=>{await navigator.clipboard?.writeText(location.href).then(()=>Pt.textContent="The address of this flight is in the clipboard.",()=>Pt.textContent=location.href)}},"copy link"),et=J("button",{id:"csv",click:()=>{let O=i.policies.flatMap(({name:ie},ge)=>l[ge]?[[ie,l[ge]]]:[]);a&&yh("flight.csv",new Blob([yp(O,a.reference,t)],{type:"text/csv"}))}},"CSV"),ht=J("button",{id:"png",click:()=>{it(0),bp(m,g.flatMap(({element:ie})=>ie.hidden?[]:[ie]),E.map(({plot:ie})=>ie),S()).toBlob(ie=>ie&&yh("flight.png",ie))}},"PNG"),we=(O,...ie)=>J("fieldset",{},J("legend",{},O),...ie),It=(O,...ie)=>J("details",{},J("summary",{},O),...ie),Ye=J("div",{class:"stack"},J("label",{class:"choice",for:"method"},"plan by",K),$("duration","duration",()=>N().durations.length,O=>te({duration:N().durations[O]})),$("pitch","pitch limit",()=>N().pitch_limits_deg.length,O=>te({pitchLimit:N().pitch_limits_deg[O]})),$("window","voltage window",()=>N().windows.length,O=>te({window:N().windows[O]})),xe,be,Pe);e.classList.add("live"),e.append(J("header",{},J("h1",{},"3-DOF helicopter"),J("p",{},"A 360\xB0 rotation between two points of rest, planned within limits and flown in your browser.")),y,J("div",{class:"transport"},Ne,qe,ut,J("span",{class:"pushes"},J("span",{},"push"),...Jt),nt),J("div",{class:"panels"},...E.map(({plot:O})=>O.element)),P.element,J("aside",{},we("Tasks",me.element),we("Rig and plan",J("label",{class:"choice",for:"rig"},"rig",ue),It("where its numbers are from",de),Ye),we("Flight",$("startOff","start off by",()=>11,O=>te({startOff:O})),J("div",{class:"toggles"},...Ve.map(({label:O})=>O)),It("your weights in (49)",J("p",{class:"small"},"Factors on the paper's Q and R, for the policy \u201Cyour weights\u201D."),...ye)),we("Plant",ct,Qe,J("div",{class:"row"},Ge),It("its effects, one by one",...ft,tt)),we("Files",J("div",{class:"row"},et,ht,De),J("label",{class:"file"},"open a recorded flight (CSV)",kt),B,Pt),hl([["Space","fly, pause"],["R","restart"],["\u2190 \u2192","push the pitch; on a plot, move the time; on the 3D view, look around"],["\u2191 \u2193","lift, press the body"],[ix.join(" "),"nominal, lab, rigid, fleet"],["D","another draw of the plant"],[sx.join(" "),"show or hide each policy"]]),J("p",{class:"small"},"Pale helicopter and dashed lines: the plan. Shaded: beyond its limits. The start is off in travel and elevation. Drag a body to push it."),A.element));let Ke=Iu(m,vn(i,r.rig).body,vn(i,r.rig).parameters);Ke&&(Ke.onBodyDrag=(O,ie)=>{let ge=Be=>Math.min(Math.max(Tf.perPixel*Be,-Tf.most),Tf.most);d=[ge(O),ge(ie)],d.some(Be=>Be!==0)&&!f&&h<R()&&oe(!0)});let R=()=>t*(a?.steps??0),S=()=>{let{rig:O,plant:ie,startOff:ge}=r,Be=c?`recorded flight ${c.name}`:`${q.duration()}, pitch ${q.pitch()}, ${q.window()}`;return`rig ${O}, plant ${ie}; ${Be}; start off by ${ge}\xB0`};function Y(O){for(let ie of _r(vn(i,r.rig),O).durations){let ge=zs({...r,method:O,duration:ie},i);if(xl(ge,i))return ge}return null}function he(){let O=vn(i,r.rig);a=jr.make(r,i,c),Te(O);let ie=a===null;if(xe.hidden=be.hidden=!ie,y.classList.toggle("stale",ie),ce(),ie){let[Be,_t]=[Y(r.method),Y("spline")],mt=_t&&Gs(_t,i);xe.textContent=[`No plan for ${q.duration()} within ${q.pitch()} and ${q.window()}`,r.method==="paper"?Be?`: the paper's method finds none below ${Gs(Be,i).toFixed(1)} s`:": the paper's method finds none":"",mt===null?".":`; the fastest of the splines takes ${mt.toFixed(2)} s.`].join(""),be.hidden=_t===null,be.textContent=mt===null?"":`take the spline of ${mt.toFixed(2)} s`,oe(!1);return}Ke?.setRig(O.body,O.parameters);let ge=ca(r);G.setLimits(ge.pitch.map(Vt)),H.forEach(Be=>{Be.setLimits(ge.u),Be.setRange(O.amplifier)}),E.forEach(({plot:Be})=>Be.setDuration(R())),P.rebuild(a,o),Me()}function ce(){let O=i.policies.flatMap(({name:ie},ge)=>o[ge]?[ie]:[]);try{history.replaceState(null,"",wp(r,O,i)||location.pathname+location.search)}catch{}}function Te(O){V.forEach(mt=>mt()),ue.value=O.name,de.textContent=O.source||"from a file",K.value=r.method,K.options[0].disabled=!O.grids.paper,Pe.textContent=O.grids.paper?"the paper's values":"as at first",Ye.hidden=c!==null,B.hidden=c===null,i.policies.forEach(({name:mt},sn)=>{let Tn=mt!=="residual"||Object.values(O.networks).some(({learned:zt})=>zt!==null);Ve[sn].label.hidden=!Tn,Ve[sn].box.checked=o[sn],ae(sn,o[sn]&&Tn)}),ct.replaceChildren(...Object.keys(O.plants).map(mt=>{let sn=J("input",{type:"radio",name:"plant",value:mt,checked:mt===r.plant});return sn.addEventListener("change",()=>Re(mt)),J("label",{},sn,J("span",{},mt))}));let{plant:ie,isRandom:ge}=_l(r,i);Ge.hidden=!ge,tt.hidden=Object.keys(r.effects).length===0;let Be=la(ie),_t=mt=>`${gr[mt].name} ${Pn(Be[mt],gr[mt].digits)} ${gr[mt].unit}`;Qe.textContent=(O1[r.plant]??"")+(ge?` Draw ${r.draw}: ${Bs.filter(mt=>Math.abs(Be[mt])>1e-9).map(_t).join(", ")}.`:"")+(O.networks[O.network_for[r.plant]]?.learned?` The residual policy was trained on ${O.network_for[r.plant]}.`:"")}function Me(){a!==null&&(h=0,u=[],l=i.policies.map(()=>null),se(),oe(!0))}function se(){if(a===null)return;let O=Math.min(Math.ceil(h/t-1e-9),a.steps),ie=Math.max(0,...l.map(ge=>ge?ge.x.length-1:0));O>ie&&d.forEach((ge,Be)=>{ge!==0&&(u=[...u,{axis:2-Be,acceleration:ge,time:ie*t,duration:(O-ie)*t}])}),i.policies.forEach(({name:ge},Be)=>{if(!o[Be])return;let _t=l[Be]??=a.begin(ge);for(;_t&&_t.x.length<=O&&!_t.crashed;)_t.step(u)})}function oe(O){let ie=h>=R(),ge=O&&ie&&h>0;if(f=O&&a!==null,p=!0,f&&ge){Me();return}Ne.textContent=f?"Pause":ie&&h>0?"Fly again":"Fly",Ne.disabled=a===null}function _e(){oe(!1);let O=i.policies.flatMap(({name:ie},ge)=>l[ge]?[[ie,l[ge]]]:[]);me.complete({experiment:a,flights:Object.fromEntries(O),wasPushed:u.length>0})}function k(O,ie){let ge=Math.max(0,...l.map(Be=>Be?Be.x.length-1:0));u=[...u,{axis:O,acceleration:ie,time:ge*t,duration:F1}]}function le(O,ie){o[O]=Ve[O].box.checked=ie,ie||(l[O]=null),ae(O,ie),se(),ce(),p=!0}function ae(O,ie){g[O].element.hidden=!ie,E.forEach(({plot:ge})=>ge.setVisible(O,ie)),P.setVisible(O,ie)}function Re(O){te({plant:O,effects:{}}),he()}function Se(){te({draw:r.draw+1,effects:{}}),he()}async function Ae(O){try{c=Mp(await O.text(),O.name,t/2)}catch(ge){Pt.textContent=ge.message;return}i.policies.forEach(({name:ge},Be)=>o[Be]=ge==="open-loop"),te({startOff:0}),he();let ie=Sp(c,a.plant,a.rules);Pt.textContent=`${O.name}: ${(c.step*(c.x.length-1)).toFixed(1)} s. Dashed and pale: the record; \u201Copen loop\u201D: the model under the recorded voltages. One second ahead, the model is off by ${["travel","elevation","pitch"].map((ge,Be)=>`${Pn(ie[Be],1)}\xB0 of ${ge}`).join(", ")} (RMS).`}function Je(O){let{plot:ie,value:ge,planned:Be}=E[O],{x:_t,middle:mt}=a.reference,sn=_t.map((zt,Un)=>Un*t),Tn=l.map(zt=>sn.map((Un,Bn)=>zt&&Bn<zt.x.length?ge(zt.x[Bn],zt.u[Math.min(Bn,zt.u.length-1)]??mt[0],Bn):null));ie.show(sn,Be?[...Tn,_t.map((zt,Un)=>ge(zt,mt[Un],Un))]:Tn),ie.seek(h)}function it(O){if(a===null)return;ut.textContent=`${Pn(Math.min(h,R()),1)} s`;let ie=ox(a.reference.x,h/t),ge=[];l.forEach((Be,_t)=>{if(!Be)return;let mt=Math.min(h/t,Be.x.length-1),sn=ox(Be.x,mt),Tn=Be.crashed&&mt>=Be.x.length-1?`beyond \xB1${Vt(a.rules.pitchStop).toFixed(0)}\xB0 of pitch: the flight ended`:"",zt=Be.u[Math.min(Math.floor(mt),Be.u.length-1)]??Be.rotors;g[_t].show(sn,zt,Tn),ge.push({element:g[_t].element,colour:n[_t],x:sn,u:Tn?[0,0]:f?Be.rotors:zt,ghost:ie})}),Ke?.draw(ge,O)}let pe=performance.now(),He=0;function st(O){let ie=Math.min(Math.max((O-pe)/1e3,0),.1);pe=O,A.measure(()=>{if(f&&(h=Math.min(h+v*ie,R()),se(),h>=R()&&_e()),!f&&!p&&!Ke?.moved)return;let ge=!f&&p;p=!1,it(f?v*ie:0),a!==null&&(f&&He++%2?Je((He>>1)%E.length):f?P.refresh(l,h,!1):ge&&(E.forEach((Be,_t)=>Je(_t)),P.refresh(l,h,!0)))}),requestAnimationFrame(st)}window.addEventListener("keydown",O=>{if(ul(O))return;let ie=O.key.length===1?O.key.toLowerCase():O.key,ge=nx.find(mt=>mt.key===ie),Be=Object.keys(vn(i,r.rig).plants)[ix.indexOf(ie)],_t=sx.indexOf(ie);if(ge)k(ge.axis,ge.acceleration);else if(ie===" ")oe(!f);else if(ie==="r")Me();else if(ie==="d"&&!Ge.hidden)Se();else if(Be)Re(Be);else if(Ve[_t]&&!Ve[_t].label.hidden)le(_t,!o[_t]);else return;O.preventDefault()}),window.addEventListener("hashchange",()=>{let O=bh(location.hash,i);r=O.setup,i.policies.forEach(({name:ie},ge)=>o[ge]=O.shown.includes(ie)),c=null,he()}),document.addEventListener("dragover",O=>O.preventDefault()),document.addEventListener("drop",O=>{O.preventDefault();let ie=O.dataTransfer?.files[0];ie&&Ae(ie)}),Us(()=>p=!0),e.dataset.ready="",he(),matchMedia("(prefers-reduced-motion: reduce)").matches&&oe(!1),requestAnimationFrame(st)}var rx=i=>Pn(i,Number.isInteger(i)?0:1);function ox(i,e){let t=Math.min(Math.floor(e),i.length-1),n=i[Math.min(t+1,i.length-1)];return i[t].map((s,r)=>s+(e-t)*(n[r]-s))}var Vo=300,B1=84,Fr=62,rl=24,Uu=class{element;marks;figures;place;constructor(e,t,n){let s=e.flat().filter(l=>l>0),r=Math.log10(Math.min(...s))-.05,o=Math.max(Math.log10(Math.max(...s))+.05,r+.2);this.place=l=>Vo*(Math.log10(Math.max(l,10**r))-r)/(o-r);let a=[.01,.02,.05,.1,.2,.5,1,2,5,10,20,50,100,200,500].filter(l=>Math.log10(l)>r&&Math.log10(l)<o),c=Math.ceil(a.length/7);this.marks=[],this.figures=e.map((l,u)=>{let d=new Array(rl).fill(0);for(let m of l)d[Math.min(rl-1,Math.max(0,Math.floor(rl*this.place(m)/Vo)))]+=1;let h=Math.max(...d,1),f=[...l].sort((m,y)=>m-y)[Math.floor(l.length/2)],p=`${t[u]}: ${l.length} episodes, median ${Pn(f??Number.NaN,2)}\xB0`,v=jt("svg",{viewBox:`0 0 ${Vo} ${B1}`,role:"img","aria-label":p});a.forEach((m,y)=>{if(y%c>0)return;let A=this.place(m);v.append(jt("line",{x1:A,x2:A,y1:4,y2:Fr,class:"grid"}),jt("text",{x:A,y:Fr+14,class:"tick"},`${m}`))}),d.forEach((m,y)=>{let A=(Fr-6)*(m/h);v.append(jt("rect",{x:y*Vo/rl+.5,width:Vo/rl-1,y:Fr-A,height:A,fill:n[u]}))});let g=jt("line",{y1:2,y2:Fr+3,class:"mark"});return v.append(jt("line",{x1:0,x2:Vo,y1:Fr,y2:Fr,class:"axis"}),g),this.marks.push(g),J("figure",{class:"histogram"},J("figcaption",{},J("span",{},ei(u,n[u]),p)),v)}),this.element=J("div",{class:"multiples"},...this.figures)}mark(e){this.marks.forEach((t,n)=>{let s=e[n];if(t.toggleAttribute("hidden",s==null),s==null)return;let r=this.place(s).toFixed(1);t.setAttribute("x1",r),t.setAttribute("x2",r)})}setVisible(e,t){this.figures[e].hidden=!t}};var k1=[.25,.5,1,2,4],z1=["travel","elevation","pitch"],lx=["#0072B2","#56B4E9","#009E73","#E69F00","#CC79A7","#7A5195"],cx=["travel","travel rate","elevation","elevation rate","pitch","pitch rate"];function ux(i,e){let{policies:t,labels:n,colours:s,parameters:r,limits:o}=i,a=i.groups.map(({reference:ye,step:me})=>me*(ye.x[0].length-1)),c=t.map(()=>!0),l=i.groups[0],u=a[0],d=0,h=!1,f=1,p=J("table",{},J("thead",{},J("tr",{},...i.table.columns.map(ye=>J("th",{scope:"col"},ye)))),J("tbody",{},...i.table.rows.map((ye,me)=>J("tr",me>0&&ye[0]!==i.table.rows[me-1][0]?{class:"section"}:{},...ye.map((Ne,qe)=>{let nt=qe===1?t.indexOf(Ne):-1;return nt<0?J("td",{},Ne):J("td",{title:Ne},ei(nt,s[nt]),n[nt])}))))),v=t.map((ye,me)=>new $r(n[me],s[me],me)),g=J("canvas",{tabindex:0,role:"application","aria-label":"the flights in 3D; drag, or use the arrow keys, to look from elsewhere"}),m=J("div",{class:"stage"},g,...v.map(ye=>ye.element)),y=new Yr,A={label:"plan",colour:"",dashed:!0},b=n.map((ye,me)=>({label:ye,colour:s[me],mark:me})),C=["front","back"],E={duration:u,sync:"report",onTime:ye=>Qe(ye)},x=[],M=(ye,me,Ne="flights")=>{let qe=new Xs({...E,...ye});return x.push({plot:qe,values:me,lines:Ne}),qe.element},U=ye=>l.reference.x[0].map((me,Ne)=>Ne<ye.length?ye[Ne]:null),I=ye=>U(ye.map(Vt)),D=o.pitch.map(Vt),G=z1.flatMap((ye,me)=>[M({title:ye,unit:me===1?"deg, positive down":"deg",lines:[...b,A],...me===2&&{limits:D}},()=>[...l.flights.map(Ne=>I(Ne?.x[2*me]??[])),I(l.reference.x[2*me])]),M({title:`${ye} error`,unit:me===1?"deg, positive down":"deg",lines:b,digits:2,range:[-.01,.01]},()=>l.flights.map(Ne=>I((Ne?.x[2*me]??[]).map((qe,nt)=>qe-l.reference.x[2*me][nt]))))]),H=J("div",{class:"multiples"},...t.map((ye,me)=>M({title:n[me],unit:"V",lines:[...C.map((Ne,qe)=>({label:Ne,colour:qe===0?s[me]:"",held:!0})),...C.map(Ne=>({label:`${Ne}, plan`,colour:"#7f8a97",dashed:!0}))],limits:o.u,range:i.amplifier},()=>[...C.map((Ne,qe)=>U(l.flights[me]?.u[qe]??[])),...C.map((Ne,qe)=>U(l.reference.u[qe]))],me))),{gains:P}=i;if(P){let ye=cx.map((me,Ne)=>({label:me,colour:lx[Ne],mark:Ne}));G.push(J("div",{class:"legend wide"},...cx.map((me,Ne)=>J("span",{},ei(Ne,lx[Ne]),me))),...["thrust sum","thrust difference"].map((me,Ne)=>M({title:`gains on the ${me}`,unit:"N/rad and N s/rad",lines:ye,digits:1},()=>P.K[Ne].map(qe=>l.reference.x[0].map((nt,ut)=>Ef(qe,ut*l.step/P.step))),"gains")))}let V=([ye,me])=>[[ye,ye],[me,ye],[me,me],[ye,me]],z=ye=>{let[me,Ne]=Zr(ye,r);return[[0,2*me],[Ne-me,me+Ne],[0,2*Ne],[me-Ne,me+Ne]]},N=[new Er({title:"voltages, (6)",axes:["front voltage (V)","back voltage (V)"],corners:V(o.u),outer:V(i.amplifier),ticks:[[0,3,6,9,12],[0,3,6,9,12]],colours:s}),new Er({title:"virtual inputs, (17)\u2013(20)",axes:["thrust difference v2 (N)","thrust sum v1 (N)"],corners:z(o.u),outer:z(i.amplifier),ticks:[[-.6,-.3,0,.3,.6],[0,.4,.8,1.2]],colours:s})],re=i.errors.some(ye=>ye.length>1)?new Uu(i.errors,n,s):null,q=J("dl",{class:"draw"}),$=J("input",{type:"range",class:"time",min:0,max:u,step:.01,value:0,"aria-label":"time",id:"time"}),te=J("output",{for:"time"}),ue=J("button",{class:"primary",click:()=>ct(!h)},"Play"),de=J("select",{"aria-label":"speed"},...k1.map(ye=>J("option",{value:ye,selected:ye===1},`${ye}\xD7`))),K=J("select",{"aria-label":"flights"},...i.groups.map(({label:ye},me)=>J("option",{value:me},ye))),xe=J("div",{class:"legend"},...t.map((ye,me)=>{let Ne=J("input",{type:"checkbox",checked:!0});return Ne.addEventListener("change",()=>Pe(me,Ne.checked)),J("label",{title:ye},Ne,ei(me,s[me]),n[me])}),J("span",{class:"line dashed"},"plan"));$.addEventListener("input",()=>Qe(Number($.value))),de.addEventListener("change",()=>f=Number(de.value)),K.addEventListener("change",()=>Ve(Number(K.value))),e.append(J("header",{},J("h1",{},i.title),J("p",{},i.subtitle)),J("section",{},J("h2",{},"Results"),J("p",{},i.table.title),Zf("results",p),J("p",{class:"small"},i.table.caption)),J("section",{},J("h2",{},"Flights"),J("div",{class:"bar"},J("label",{},"flights ",K),xe),m,q),...re===null?[]:[J("section",{},J("h2",{},"RMS error over all episodes (deg)"),re.element,J("p",{class:"small"},"Travel and elevation together, on a logarithmic axis; the line marks the flight that is shown."))],J("section",{},J("div",{class:"panels"},...G,...N.map(ye=>ye.element)),J("h2",{},"Voltages"),J("p",{class:"small"},"Coloured: front motor; black: back motor; dashed: the plan."),H,J("p",{class:"small"},"Shaded: beyond the limits of the plan. Drag across a plot to zoom, double-click to see all, click to go to a time.")),J("footer",{},hl([["Space","play, pause"],["\u2190 \u2192","0.1 s back, forwards (with Shift 1 s); on the 3D view, look around"],["Home End","to the start, to the end"],["1 2","first, second choice of flights"],["+ - 0","on a plot: zoom in, out, show all"]]),y.element),J("div",{class:"transport"},ue,$,te,de));let be=Iu(g,i.rig,r);function Pe(ye,me){c[ye]=me,Ee(),Ge(0)}function Ee(){t.forEach((ye,me)=>{let Ne=c[me]&&l.flights[me]!==null;v[me].element.hidden=!Ne;for(let{plot:qe,lines:nt}of x)nt==="flights"?qe.setVisible(me,Ne):nt===me&&(qe.element.hidden=!Ne);for(let qe of N)qe.setVisible(me,Ne);re?.setVisible(me,c[me]&&i.errors[me].length>0)})}function Ve(ye){l=i.groups[ye],u=a[ye],K.value=`${ye}`,$.max=`${u}`;let me=l.reference.x[0].map((qe,nt)=>nt*l.step);for(let{plot:qe,values:nt}of x)qe.show(me,nt());let Ne=l.flights.map(qe=>(qe?.u[0]??[]).map((nt,ut)=>[nt,qe.u[1][ut]]));N[0].show(Ne),N[1].show(Ne.map(qe=>qe.map(nt=>ii(nt,r).reverse()))),q.replaceChildren(...l.draw.map(([qe,nt])=>J("div",{},J("dt",{},qe),J("dd",{},nt)))),q.hidden=l.draw.length===0,re?.mark(l.errors),Ee(),Qe(Math.min(d,u))}function Qe(ye,me=0){d=Math.min(Math.max(ye,0),u),$.value=`${d}`,te.textContent=`${Pn(d,2)} s`;for(let{plot:Ne}of x)Ne.seek(d);for(let Ne of N)Ne.seek(Math.round(d/l.step));Ge(me)}function Ge(ye){let me=d/l.step,Ne=[],qe=l.reference.x.map(nt=>Ef(nt,me));l.flights.forEach((nt,ut)=>{if(nt===null)return;let Jt=nt.x[0].length-1,Pt=nt.x.map(B=>Ef(B,me)),kt=nt.u.map(B=>B[Math.min(Math.floor(me),Jt)]);v[ut].show(Pt,kt,me>Jt?nt.ended:""),c[ut]&&Ne.push({element:v[ut].element,colour:s[ut],x:Pt,u:kt,ghost:qe})}),be?.draw(Ne,ye)}function ct(ye){ye&&d>=u&&(d=0),h=ye,ue.textContent=ye?"Pause":"Play"}let ft=performance.now();function tt(ye){let me=Math.min(Math.max((ye-ft)/1e3,0),.1);ft=ye,y.measure(()=>{h?Qe(d+f*me,f*me):be?.moved&&Ge(0)}),h&&d>=u&&ct(!1),requestAnimationFrame(tt)}window.addEventListener("keydown",ye=>{if(ul(ye))return;let me=ye.shiftKey?1:.1,Ne={" ":()=>ct(!h),ArrowLeft:()=>Qe(d-me),ArrowRight:()=>Qe(d+me),Home:()=>Qe(0),End:()=>Qe(u)},qe=Number(ye.key)-1;if(i.groups[qe])Ve(qe);else if(Ne[ye.key])Ne[ye.key]();else return;ye.preventDefault()}),Us(()=>Ge(0)),Ve(0),requestAnimationFrame(tt)}function Ef(i,e){let t=Math.min(Math.max(Math.floor(e),0),i.length-1),n=Math.min(t+1,i.length-1),s=Math.min(Math.max(e-t,0),1);return(1-s)*i[t]+s*i[n]}if(typeof document<"u"){let i=JSON.parse(document.getElementById("data").textContent),e=document.querySelector("main");document.body.dataset.kind==="live"?ax(i,e):ux(i,e)}return Rx(G1);})();
/* three

The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
/* uplot

The MIT License (MIT)

Copyright (c) 2022 Leon Sorokin

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.
*/
