// built from web/, sources sha256:2134be1b8f298b60eb8925ece35805af2369e54a47521b607c0fc16f52b164cc
"use strict";var heli=(()=>{var Zu=Object.defineProperty;var Lx=Object.getOwnPropertyDescriptor;var Dx=Object.getOwnPropertyNames;var Nx=Object.prototype.hasOwnProperty;var Ux=(i,e)=>{for(var t in e)Zu(i,t,{get:e[t],enumerable:!0})},Fx=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of Dx(e))!Nx.call(i,s)&&s!==t&&Zu(i,s,{get:()=>e[s],enumerable:!(n=Lx(e,s))||n.enumerable});return i};var Ox=i=>Fx(Zu({},"__esModule",{value:!0}),i);var J1={};Ux(J1,{ARRIVED:()=>Uf,EFFECTS:()=>es,EFFECT_NAMES:()=>gs,Experiment:()=>yr,Flight:()=>la,HOLD:()=>Ip,KalmanController:()=>ta,ResidualController:()=>ia,TASKS:()=>ll,TaskList:()=>cl,WEIGHTS:()=>xs,actions:()=>bp,advance:()=>aa,atRest:()=>oa,basis:()=>uh,clip:()=>di,controlGrid:()=>na,controllersAlong:()=>yh,coriolis:()=>lp,drawn:()=>jr,durationOf:()=>vs,dynamics:()=>zn,effectsOf:()=>Qr,fanThrusts:()=>eh,feedforward:()=>Kr,footForce:()=>Ku,friction:()=>yl,fromHash:()=>wl,generalisedForces:()=>up,gravity:()=>cp,gridOf:()=>Xs,hoverInput:()=>Ni,hoverTracking:()=>ph,initialSetup:()=>Ws,inputAt:()=>ri,integratePlan:()=>Mh,internalDynamics:()=>ch,inverseDynamics:()=>Vs,kalmanLqrGains:()=>mh,limitsOf:()=>eo,linearise:()=>Hs,massMatrix:()=>ap,measurement:()=>bh,modelOf:()=>Ep,oneSecondAhead:()=>Ch,parseLog:()=>Rh,placeOf:()=>ua,plantOf:()=>da,powerThrust:()=>Qu,prepared:()=>ra,quantise:()=>lh,riccatiGains:()=>sa,rigOf:()=>yn,rigidDynamics:()=>ih,rk4Step:()=>Ti,save:()=>Sl,shownAtFirst:()=>Ih,snapped:()=>_s,solveSymmetric:()=>hp,solve_2x2:()=>th,splinePlan:()=>Sh,storedPlan:()=>ha,thrust:()=>ju,thrustAt:()=>bl,thrustBounds:()=>Jr,thrustVector:()=>nh,thrusts:()=>si,toCsv:()=>Eh,toHash:()=>Ph,toPicture:()=>Ah,trackingController:()=>fh,unpacked:()=>xh,virtualInput:()=>ea,voltageFor:()=>Ml,voltages:()=>fi,weightsOf:()=>Lp,withContact:()=>ah,withCoupling:()=>oh,withFrictionAndDisturbances:()=>sh,withLift:()=>rh,withStationaryCost:()=>_h});function an(i,e,t=""){let n=document.createElementNS("http://www.w3.org/2000/svg",i);for(let[s,r]of Object.entries(e))n.setAttribute(s,String(r));return n.textContent=t,n}var pl=i=>i.map(([e,t])=>`${e.toFixed(1)},${t.toFixed(1)}`).join(" ");var ip=["M-0.9,0 A0.9,0.9 0 1 0 0.9,0 A0.9,0.9 0 1 0 -0.9,0 Z","M-0.8,-0.8 H0.8 V0.8 H-0.8 Z","M0,-1 L0.95,0.75 H-0.95 Z","M0,-1.1 L1.1,0 L0,1.1 L-1.1,0 Z","M0,1 L0.95,-0.75 H-0.95 Z","M-0.35,-1 H0.35 V-0.35 H1 V0.35 H0.35 V1 H-0.35 V0.35 H-1 V-0.35 H-0.35 Z"],sp=[[],[9,3],[2,3],[9,3,2,3],[5,3],[12,4,2,4,2,4]],Ko=i=>ip[i%ip.length],rp=i=>sp[i%sp.length];function ni(i,e,t=""){let s=an("svg",{viewBox:"-1.3 -1.3 2.6 2.6",class:"swatch",...t?{role:"img","aria-label":t}:{"aria-hidden":"true"}});return s.append(an("path",{d:Ko(i),fill:e})),s}function J(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))typeof r=="function"?n.addEventListener(s,r):typeof r=="boolean"?n.toggleAttribute(s,r):n.setAttribute(s,String(r));return n.append(...t),n}var $t=i=>i*180/Math.PI,mr=i=>i*Math.PI/180,Nn=(i,e)=>i.toFixed(e).replace(/^-(?=.*[1-9])/,"\u2212").replace(/^-/,"");function hi(i){return getComputedStyle(document.documentElement).getPropertyValue(`--${i}`).trim()}var ml=()=>matchMedia("print").matches;function gl(i,e){window.addEventListener("beforeprint",()=>{i.style.setProperty("--aspect",`${i.clientWidth} / ${i.clientHeight}`),i.style.setProperty("--columns",`${getComputedStyle(i).gridTemplateColumns.split(" ").length}`),e()})}function Gs(i){for(let e of["(prefers-color-scheme: dark)","print"])matchMedia(e).addEventListener("change",i)}function xl(i){let e=i.target;return i.ctrlKey||i.metaKey||i.altKey||e.matches("select, textarea, input[type=text]")?!0:e.matches("input[type=range], input[type=radio], [role=slider], [role=application], .scroll")?/^(Arrow|Home|End|Page|[-+=0])/.test(i.key):e.matches("button, summary, a, input")&&[" ","Enter"].includes(i.key)}function _l(i){let e=i.flatMap(([t,n])=>[J("dt",{},...t.split(" ").map(s=>J("kbd",{},s))),J("dd",{},n)]);return J("details",{class:"help"},J("summary",{},"Keyboard"),J("dl",{},...e))}function op(i,e){let t=J("div",{class:"scroll",tabindex:0,role:"region","aria-label":i},e),n=J("p",{class:"small hint",hidden:!0},"Scroll sideways for all columns \u2192");return new ResizeObserver(()=>n.hidden=t.scrollWidth<=t.clientWidth+1).observe(t),J("div",{},n,t)}var $r=class{element=J("span",{class:"meter"});frames=0;busy=0;since=performance.now();measure(e){let t=performance.now();e(),queueMicrotask(()=>this.count(t))}count(e){let t=performance.now();if(this.busy+=t-e,this.frames+=1,t-this.since>=1e3){let n=1e3*this.frames/(t-this.since),s=this.busy/this.frames;this.element.textContent=`${n.toFixed(0)} frames/s, ${s.toFixed(1)} ms of script each`,Object.assign(this.element.dataset,{rate:n,script:s}),[this.frames,this.busy,this.since]=[0,0,t]}}},Zr=class{element;numbers=["travel","elevation","pitch","front","back"].map(e=>J("span",{title:e}));note=J("div",{class:"note"});constructor(e,t,n){let s=J("div",{class:"name"},ni(n,t),e);this.element=J("div",{class:"view"},s,this.note,J("div",{class:"numbers"},...this.numbers))}show(e,t,n){[e[0],e[2],e[4]].forEach((s,r)=>this.write(r,`${Nn($t(s),1)}\xB0`)),t.forEach((s,r)=>this.write(3+r,`${Nn(s,1)} V`)),this.note.textContent=n,this.note.hidden=n===""}write(e,t){let n=`${this.numbers[e].title} ${t}`;this.numbers[e].textContent!==n&&(this.numbers[e].textContent=n)}};var ii=i=>i[0].map((e,t)=>i.map(n=>n[t]));function gr(i,e){return i.map(t=>{let n=0;for(let s=0;s<t.length;s++)n+=t[s]*e[s];return n})}function mn(i,e){let t=ii(e);return i.map(n=>gr(t,n))}var xr=(i,e)=>i.map((t,n)=>t-e[n]),ms=(i,e,t=1)=>i.map((n,s)=>n.map((r,o)=>r+t*e[s][o])),jo=(i,e)=>i.map(t=>t.map(n=>e*n)),_r=i=>i.map((e,t)=>e.map((n,s)=>.5*(n+i[s][t]))),vl=(i,e)=>Array.from({length:i},()=>new Array(e).fill(0)),Ju=i=>i.map((e,t)=>i.map((n,s)=>t===s?e:0));function vr(i,e){let t=i.length,n=i.map((s,r)=>[...s,...e[r]]);for(let s=0;s<t;s++){n[s]=n[s].map(r=>r/n[s][s]);for(let r=0;r<t;r++){if(r===s)continue;let o=n[r][s];n[r]=n[r].map((a,c)=>a-o*n[s][c])}}return n.map(s=>s.slice(t))}var Qo=i=>Array.from(new Float32Array(Uint8Array.from(atob(i),e=>e.charCodeAt(0)).buffer));var Bx=6.283185307179586;function ju(i,e){let t=e.k_plus+e.k_minus,n=e.k_plus-e.k_minus;return .5*(t*i+n*Math.abs(i))*i}function Qu(i,e,t,n,s){let r=Math.abs(i)-s,o=Math.pow(.5*(r+Math.abs(r)),n),a=i/(Math.abs(i)+1e-30);return .5*(e+t+(e-t)*a)*o}function ea(i){return[i[0]+i[1],i[0]-i[1]]}function eh(i){return[.5*(i[0]+i[1]),.5*(i[0]-i[1])]}function zn(i,e,t){let[,n,s,r,o,a]=i,[c,l]=e,u=t,d=u.b1*Math.cos(s)*Math.sin(o)*c-u.c1*n,h=u.a1*Math.sin(s)+u.a2*Math.cos(s)+u.b2*Math.cos(o)*c-u.c2*r,f=u.a3*Math.cos(s)*Math.sin(o)+u.b3*l-u.c3*a;return[n,d,r,h,a,f]}function th(i,e,t,n,s,r){let o=i*n-e*t;return[(n*s-e*r)/o,(i*r-t*s)/o]}function Vs(i,e,t,n){let[,,,s,,r]=zn(i,[0,0],n),[,,,o,,a]=zn(i,[1,0],n),[,,,c,,l]=zn(i,[0,1],n);return th(o-s,c-s,a-r,l-r,e-s,t-r)}function nh(i,e,t,n){let[s,r,o,a,,c]=i,l=[s,r,o,a,0*o,c],u=[s,r,o,a,0*o+.5*Math.PI,c],[,d,,h,,]=zn(l,[0,0],n),[,f,,p,,]=zn(l,[1,0],n),[,_,,g,,]=zn(u,[1,0],n);return th(_-d,f-d,g-h,p-h,e-d,t-h)}function ap(i,e,t,n,s){let r=s.e_h-s.d_h*t,o=s.m_c*(s.l_c*i-s.d_c*e)**2+s.m_h*((s.l_h*i-r*e)**2+s.r**2*(1-i**2*n**2)+s.d_h**2*n**2),a=s.m_c*(s.l_c**2+s.d_c**2)+s.m_h*(s.l_h**2+r**2+s.r**2*n**2),c=s.m_h*(s.r**2+s.d_h**2),l=s.m_h*n*(s.r**2*i*t+s.d_h*(s.l_h*e+r*i)),u=s.m_h*((s.r**2+s.d_h**2)*e+s.d_h*t*(s.l_h*i-s.e_h*e)),d=s.m_h*s.d_h*s.l_h*n;return[o,a,c,l,u,d]}function lp(i,e,t,n,s,r,o,a){let c=a.e_h-a.d_h*t,l=a.l_h*i-c*e,u=a.l_h*e+c*i,d=a.l_c*i-a.d_c*e,h=a.l_c*e+a.d_c*i,f=2*a.m_h*(a.r**2*i*e*n**2-l*u)-2*a.m_c*d*h,p=a.m_h*n*(a.d_h*l-a.r**2*e*t),_=a.m_h*((a.r**2+a.d_h**2)*i-a.d_h*t*(a.l_h*e+a.e_h*i)),g=2*a.m_h*n*(t*(a.d_h**2-a.r**2*i**2)-a.d_h*e*l),m=2*a.m_h*n*(a.d_h*c+a.r**2*t),y=a.m_h*(a.r**2*i*(t**2-n**2)+a.d_h*(t*u+a.d_h*n**2*i)),A=-a.m_h*a.d_h*n*(a.l_h*i-a.e_h*e),S=a.m_h*a.d_h*a.l_h*t;return[s*(f*r+g*o)+p*r**2+(y+_)*r*o+A*o**2,-.5*f*s**2+(y-_)*s*o+m*r*o+S*o**2,-.5*g*s**2+(_-y)*s*r-.5*m*r**2]}function cp(i,e,t,n,s){let r=s.m_h*(s.l_h*i-(s.e_h-s.d_h*t)*e)-s.m_c*(s.l_c*i-s.d_c*e);return[0,s.g*r,s.g*s.m_h*s.d_h*n*i]}function up(i,e,t,n,s,r,o){let a=-o.kappa*r;return[-s*n*(o.l_h*i-o.e_h*e)+o.l_p*e*r+a*i*t,o.l_h*t*s+a*n,o.l_p*r]}function hp(i,e){let[t,n,s,r,o,a]=i,[c,l,u]=e,d=n*s-a**2,h=t*s-o**2,f=t*n-r**2,p=o*a-r*s,_=r*a-o*n,g=r*o-t*a,m=t*d+r*p+o*_;return[(d*c+p*l+_*u)/m,(p*c+h*l+g*u)/m,(_*c+g*l+f*u)/m]}function ih(i,e,t){let[,n,s,r,o,a]=i,[c,l]=e,u=Math.cos(s),d=-Math.sin(s),h=Math.cos(o),f=Math.sin(o),p=ap(u,d,h,f,t),[_,g,m]=lp(u,d,h,f,n,-r,a,t),[y,A,S]=cp(u,d,h,f,t),[P,E,x]=up(u,d,h,f,c,l,t),[b,N,R]=hp(p,[P-_-y,E-g-A,x-m-S]);return[n,b,r,-N,a,R]}function yl(i,e,t){return e*i+t*i/(i*i+.02*.02)**.5}function sh(i,e,t,n,s){let[r,o,a,c,l,u]=e,[d,h,f,p]=s;return[r,o+d-yl(r,t[0],n[0]),a,c+h+p*Math.cos(i[2])-yl(a,t[1],n[1]),l,u+f-yl(l,t[2],n[2])]}function rh(i,e){let[t,n,s,r,o,a]=i;return[t,n,s,r+e*t*t,o,a]}function oh(i,e,t,n,s){let[,r,o,a,c,l]=i,[u,d,h,f,p,_]=e,g=n,[m,y,A,S,P]=s,E=Math.sin(o-y),x=Math.cos(o-y),b=Math.sin(c),N=Math.cos(c),R=S*.27*g.b2/g.b3*l;return[u,d+2*m*E/x*r*a+R*b,h,f-m*E*x*r*r+R*N,p,_+P*t*r-A*b*N*(r*r-a*a)+S*(a*N+r*b)]}function Ku(i,e,t){let n=.5*(i+Math.abs(i)),s=60*n/(n+.001),r=.5*(900*n+s*e)/Math.abs(t);return .5*(r+Math.abs(r))}function ah(i,e,t,n){let[s,r,o,a,c,l]=e,u=t,[d,h]=n,f=.27*Math.cos(i[4])*c,p=.27*Math.sin(i[4]),_=Ku(i[2]-p-d,o-f,u.b2),g=Ku(i[2]+p-d,o+f,u.b2),m=_+g,y=s/(s*s+.02*.02)**.5;return[s,r-Math.abs(u.b1)*h*m*y,o,a-Math.abs(u.b2)*m,c,l+u.b3*(_-g)]}function lh(i,e){let t=Bx/e;return t*Math.floor(i/t+.5)}function ch(i,e,t){return zn(i,Vs(i,e,0,t),t)[1]}function uh(i){let e=1-i;return[[e**3/6,(3*i**3-6*i**2+4)/6,(3*e**3-6*e**2+4)/6,i**3/6],[-.5*e**2,1.5*i**2-2*i,.5+i-1.5*i**2,.5*i**2],[e,3*i-2,1-3*i,i]]}var kx=60;function bl(i,e){if("cubics"in e)return mp(i,e);let{k_plus:t,k_minus:n,exponent:s,dead_zone:r}=e;return s===2&&r===0?ju(i,e):Qu(i,t,n,s,r)}function Ml(i,e){if("cubics"in e)return zx(i,e);let t=i>=0?e.k_plus:e.k_minus,n=t===0?0:i/t,s=e.exponent===2?Math.sqrt(n):n**(1/e.exponent);return Math.sign(i)*(s+(n>0?e.dead_zone:0))}var dp=({cubics:[i,e,t,n]},s,r)=>((i[s]*r+e[s])*r+t[s])*r+n[s];function fp(i,e){let t=i.findIndex(n=>n>=e);return Math.min(Math.max((t<0?i.length:t)-1,0),i.length-2)}function pp({voltages:i,thrusts:e}){let t=i.length-1;return[(e[1]-e[0])/(i[1]-i[0]),(e[t]-e[t-1])/(i[t]-i[t-1])]}function mp(i,e){let{voltages:t}=e,n=Math.min(Math.max(i,t[0]),t.at(-1)),s=fp(t,n),[r,o]=pp(e);return dp(e,s,n-t[s])+r*Math.min(i-n,0)+o*Math.max(i-n,0)}function zx(i,e){let{voltages:t,thrusts:n}=e;if(i===mp(0,e))return 0;let s=fp(n,i),r=Math.min(Math.max(i,n[0]),n.at(-1)),[o,a]=[0,t[s+1]-t[s]];for(let u=0;u<kx;u++){let d=.5*(o+a);dp(e,s,d)<r?o=d:a=d}let[c,l]=pp(e);return t[s]+a+Math.min(i-n[0],0)/c+Math.max(i-n.at(-1),0)/l}var di=(i,[e,t])=>Math.min(Math.max(i,e),t),si=(i,e)=>[bl(i[0],e.front),bl(i[1],e.back)],ri=(i,e)=>ea(si(i,e));function fi(i,e){let[t,n]=eh(i);return[Ml(t,e.front),Ml(n,e.back)]}function Jr([i,e],t){return[Math.max(...si([i,i],t)),Math.min(...si([e,e],t))]}function Hs(i,e,t){let n=[...i,...e],s=.001,r=n.map((a,c)=>{let l=f=>{let p=n.with(c,n[c]+f);return zn(p.slice(0,6),[p[6],p[7]],t)},u=f=>{let[p,_]=[l(f),l(-f)];return p.map((g,m)=>(g-_[m])/(2*f))},[d,h]=[u(s),u(2*s)];return d.map((f,p)=>(4*f-h[p])/3)}),o=i.map((a,c)=>r.map(l=>l[c]));return{A:o.map(a=>a.slice(0,6)),B:o.map(a=>a.slice(6))}}var Ni=(i,e)=>Vs([0,0,i,0,0,0],0,0,e);function Ti(i,e,[t,n,s],r){let o=(d,h)=>e.map((f,p)=>f+d*h[p]),a=i(e,t),c=i(o(r/2,a),n),l=i(o(r/2,c),n),u=i(o(r,l),s);return e.map((d,h)=>d+r/6*(a[h]+2*(c[h]+l[h])+u[h]))}var gp=[0,2,4],hh=[1,3,5];function xp(i,e,t,n,s,{lag:r},o){let a=h=>t.map((f,p)=>r?f+(e[p]-f)*Math.exp(-h/r):f),c=(h,f)=>{let p=zn(h,f,o);return hh.forEach((_,g)=>p[_]+=n[g]),p},[l,u,d]=[0,.5,1].map(h=>ri(a(h*s),o));return{x:Ti(c,i,[l,u,d],s),rotors:a(s)}}function dh(i,e,t){let n=i.length,s=n+e[0].length,r=Array.from({length:s},(l,u)=>u<n?[...i[u],...e[u]]:new Array(s).fill(0)),o=Ju(new Array(s).fill(1)),a=o;for(let l=1;l<=4;l++)o=jo(mn(r,o),t/l),a=ms(a,o);let c=a.slice(0,n);return{A:c.map(l=>l.slice(0,n)),B:c.map(l=>l.slice(n))}}function _p(i,e,t,n,{noise:s,encoder_noise:r,start_deviations:o}){let a=vl(9,6),c=[s.travel_disturbance,s.elevation_disturbance,s.pitch_disturbance];hh.forEach((p,_)=>{a[p][_]=s.acceleration,a[6+_][3+_]=c[_]});let l=mn(a,ii(a)),[u,d,h]=o.map(p=>p**2),f=Ju([u,d,u,d,u,d,h,h,h]);return i.map((p,_)=>{let g=vl(9,9);Hs(p,e[_],n).A.forEach((E,x)=>E.forEach((b,N)=>g[x][N]=b)),hh.forEach((E,x)=>g[E][6+x]=1);let{A:m}=dh(g,vl(9,1),t),y=gp.map(E=>f[E]),A=y.map((E,x)=>gp.map((b,N)=>E[b]+(x===N?r**2:0))),S=ii(vr(A,y));f=ms(f,mn(S,y),-1);let P=ms(l,mn(m,mn(l,ii(m))));return f=_r(ms(mn(m,mn(f,ii(m))),P,.5*t)),S})}function vp(i,e,[t,n,s],r,o,a){let[,c,,l,,u]=zn(i,e,a),[d,h]=nh(i,c-t,l-n,a),f=i.with(4,di(Math.atan2(d,Math.max(h,o)),r)),[,p]=Vs(f,l-n,u-s,a);return{x:f,v:[Math.hypot(d,h),p]}}function Gx(i,e,t,n){let{A:s,B:r}=Hs(i,e,n);return{A:[...s.map((o,a)=>[...o,...r[a]]),[0,0,0,0,0,0,-1/t,0],[0,0,0,0,0,0,0,-1/t]],B:[...r.map(()=>[0,0]),[1/t,0],[0,1/t]]}}function yp(i,e,t,n,s,r){let[o,a]=[jo(s.Q,t),jo(s.R,t)],c=s.M,l=[];for(let u=i.length-1;u>=0;u--){let d=Gx(i[u],e[u],r,n),{A:h,B:f}=dh(d.A,d.B,t),[p,_]=[mn(c,h),mn(c,f)],g=vr(ms(a,mn(ii(f),_)),mn(ii(_),h));c=_r(ms(o,mn(ii(h),ms(p,mn(_,g),-1)))),l.push(g)}return l.reverse()}function na(i){let e=i.x.length-1,t=i.x.flatMap((n,s)=>s%2===0?[s]:[]);return{x:t.map(n=>i.x[n]),u:t.map(n=>i.u[n]),middle:t.map(n=>i.u[Math.min(n+1,e)])}}function fh(i,e){let{x:t,v:n,gains:s}=i;return{tracking:i,voltages(r,o){let a=Math.min(r,t.length-1);if(s===null)return fi(n[a],e);let[c,l]=gr(s[a],xr(o,t[a]));return fi([n[a][0]-c,n[a][1]-l],e)}}}function Kr({x:i,middle:e},t,n){return{x:i,v:e.map(s=>ri(s,n)),gains:t}}function ph({x:i},e,t){let n=Ni(i.at(-1)[2],t);return{x:i,v:i.map(()=>n),gains:i.map(()=>e)}}function mh({x:i,u:e},t,n,s){let r=e.map(o=>ri(o,s));return{regulator:yp(i,r,n,s,t.weights,t.actuator.lag),observer:_p(i,r,n,s,t)}}var ta=class{constructor(e,t,n){this.task=e;this.gains=t;this.settings=n;let{x:s,u:r,middle:o}=e.reference,{lag:a,delay:c}=n.actuator;[this.x,this.rotors]=[s[0],r[0]],this.pending=Array.from({length:c},()=>r[0]),this.command=o.map((l,u)=>{let d=r[Math.min(u+1,r.length-1)];return l.map((h,f)=>h+a*(d[f]-r[u][f])/e.period)})}task;gains;settings;command;x;pending;disturbance=[0,0,0];rotors;voltages(e,t){let n=this.task.reference.x.length-1,s=Math.min(e,n),{delay:r}=this.settings.actuator,o=xr(t,this.x).filter((f,p)=>p%2===0),a=gr(this.gains.observer[s],o),c=this.x.map((f,p)=>f+a[p]);this.disturbance=this.disturbance.map((f,p)=>f+a[6+p]);let l={x:c,rotors:this.rotors};for(let f of this.pending)l=this.predicted(l,f);let u=this.regulated(Math.min(s+r,n),l),[d,...h]=[...this.pending,this.limited(u)];return{x:this.x,rotors:this.rotors}=this.predicted({x:c,rotors:this.rotors},d),this.pending=h,u}limited(e){return e.map(t=>di(t,this.task.amplifier))}predicted({x:e,rotors:t},n){let{period:s,parameters:r}=this.task;return xp(e,t,n,this.disturbance,s,this.settings.actuator,r)}regulated(e,{x:t,rotors:n}){let{reference:s,pitchLimits:r,parameters:o}=this.task,{least_lift:a}=this.settings,[c,l,u]=[n,s.u[e],this.command[e]].map(f=>ri(f,o)),d=vp(s.x[e],l,this.disturbance,r,a,o),h=gr(this.gains.regulator[e],[...xr(t,d.x),...xr(c,d.v)]);return fi(u.map((f,p)=>f+(d.v[p]-l[p])-h[p]),o)}};function xh({kalman:i,learned:e}){if(e===null)return{kalman:i,learned:e};let{arrays:t,...n}=e,s=(l,u)=>{let d=Qo(l),h=d.length/u;return Array.from({length:u},(f,p)=>d.slice(p*h,(p+1)*h))},[r,o,a]=[t.bias_input,t.bias_hidden,t.bias].map(Qo),c={weight_input:s(t.weight_input,r.length),weight_hidden:s(t.weight_hidden,o.length),weight:s(t.weight,a.length),bias_input:r,bias_hidden:o,bias:a};return{kalman:i,learned:{...n,arrays:c}}}var gh=(i,e,t)=>gr(i,t).map((n,s)=>n+e[s]);function bp({arrays:i},e,t){let n=t.length,s=gh(i.weight_input,i.bias_input,e),r=gh(i.weight_hidden,i.bias_hidden,t),o=c=>.5+.5*Math.tanh(.5*(s[c]+r[c])),a=t.map((c,l)=>{let u=Math.tanh(s[2*n+l]+o(l)*r[2*n+l]);return u+o(n+l)*(c-u)});return{action:gh(i.weight,i.bias,a).map(Math.tanh),hidden:a}}var ia=class{constructor(e,t,n,s){this.base=e;this.task=t;this.network=n;this.settings=s;this.hidden=n.arrays.weight_hidden[0].map(()=>0)}base;task;network;settings;hidden;last=[0,0];voltages(e,t){let{reference:n,amplifier:s}=this.task,r=this.base.voltages(e,t),o=this.features(Math.min(e,n.x.length-1),t,r),{action:a,hidden:c}=bp(this.network,o,this.hidden);return[this.hidden,this.last]=[c,a],r.map((l,u)=>di(l,s)+this.network.scale*a[u])}features(e,t,n){let{reference:s,amplifier:r,period:o}=this.task,{tolerance:a,state_scale:c,largest:l}=this.settings,[u,d]=[.5*(r[0]+r[1]),.5*(r[1]-r[0])],h=p=>p.map(_=>(_-u)/d),f=s.x.length-1;return[...xr(t,s.x[e]).map((p,_)=>p/a[_]),...h(n),...h(s.middle[e]),...this.last,...this.network.ahead.flatMap(p=>s.x[Math.min(e+Math.round(p/o),f)].map((g,m)=>g/c[m]).slice(1))].map(p=>di(p,[-l,l]))}};var Vx=40,Mp=.05;function _h({Q:i,R:e},t,n){let s=[0,0,t,0,0,0],{A:r,B:o}=Hs(s,Ni(t,n),n),a={A:r,gain:vr(e,ii(o))},c=i.flat();for(let l=0;l<Vx;l+=Mp)c=Ti((u,d)=>Sp(u,d,i,e),c,[a,a,a],Mp);return{Q:i,R:e,M:_r(vh(c))}}var vh=i=>Array.from({length:6},(e,t)=>i.slice(6*t,6*t+6));function Sp(i,{A:e,gain:t},n,s){let r=vh(i),o=mn(r,e),a=mn(t,r),c=mn(ii(a),mn(s,a));return r.flatMap((l,u)=>l.map((d,h)=>o[u][h]+o[h][u]-c[u][h]+n[u][h]))}function sa(i,{Q:e,R:t,M:n},s){let r=i.x.map((l,u)=>{let{A:d,B:h}=Hs(l,ri(i.u[u],s),s);return{A:d,gain:vr(t,ii(h))}}),o=i.x.length-1,a=n,c=[mn(r[o].gain,a)];for(let l=o;l>0;l-=2){let u=Ti((d,h)=>Sp(d,h,e,t),a.flat(),[r[l],r[l-1],r[l-2]],2*i.step);a=_r(vh(u)),c.unshift(mn(r[l-2].gain,a))}return c}function yh(i,e,t){let{parameters:n,amplifier:s,control_period:r}=t,o=na(i),a={reference:o,pitchLimits:e,amplifier:s,period:r,parameters:n},c=wp(()=>sa(i,t.yours??t.weights,n)),l=wp(()=>sa(i,t.weights,n)),u=new Map,d=_=>(u.has(_)||u.set(_,mh(o,_,r,n)),u.get(_)),h=_=>fh(_,n),f=new Map,p=_=>(f.has(_)||f.set(_,sa(i,_,n)),h(Kr(o,f.get(_),n)));return{"feedforward+tvlqr":()=>h(Kr(o,l(),n)),yours:()=>h(Kr(o,c(),n)),"open-loop":()=>h(Kr(o,null,n)),"hover-lqr":()=>h(ph(o,t.hover_gain,n)),"kalman-lqr":({kalman:_})=>new ta(a,d(_),_),residual:({learned:_})=>_&&new ia(p(_.weights),a,_,t.features)}}function wp(i){let e;return()=>e??=i()}var Hx=1e3,Tp=1e-4;function jr(i,e,t=new Map){if(i===null||typeof i!="object")return i;if(Array.isArray(i))return i.map(n=>jr(n,e,t));if("options"in i&&Array.isArray(i.options)){let{options:n,together:s}=i,r=(s?t.get(s):void 0)??e();return s&&t.set(s,r),jr(n[Math.floor(r*n.length)],e,t)}if("low"in i&&"high"in i){let{low:n,high:s}=i;return n+(s-n)*e()}return Object.fromEntries(Object.entries(i).map(([n,s])=>[n,jr(s,e,t)]))}function Ep({parameters:i,thrust_map:e}){let t={k_plus:i.k_plus,k_minus:i.k_minus,exponent:2,dead_zone:0},n=e??t;return{...i,..."front"in n?n:{front:n,back:n}}}function Ap({coupling:i}){return Object.values(i).some(e=>e!==0)}function ra(i,e,t){let{rotors:n,friction:s,parameters:r,sensors:o}=i,a=Ep(i),c=1-n.thrust_loss;if(i.hover_voltage){let[p,_]=si([i.hover_voltage,i.hover_voltage],a);c*=-r.a2/(r.b2*(p+_))}let l=Math.floor(n.delay/e+Tp),u=Math.max(n.delay-e*l,0),d=u>Tp*e?u:0,h=i.rig===null&&n.thrust_loss===0&&n.delay===0&&n.gains.every(p=>p===1)&&[...s.viscous,...s.coulomb].every(p=>p===0)&&i.thrust_map===null&&!i.table&&i.travel_lift===0&&!Ap(i)&&i.disturbances.length===0&&!o?.zeros.some(p=>p!==0),f=[c*n.gains[0],c*n.gains[1]];return{plant:i,model:a,shares:f,periods:l,rest:d,steps:p=>h&&!p?1:Math.ceil(e/t-1e-9)}}function oa({plant:i,periods:e},t,n){return{x:[...t],motors:n,rotors:n,arrived:n,pending:Array.from({length:e},()=>n),angles:Rp(i,t),rates:[t[1],t[3],t[5]]}}function bh(i){return i.angles.flatMap((e,t)=>[e,i.rates[t]])}function aa({plant:i,model:e,shares:t,rest:n,steps:s},r,o,a,c,l,u=l.length>0){let{rotors:d,friction:h,rig:f,table:p}=i,_=s(u),g=p?[p.elevation,p.friction]:[Hx,0],{centrifugal:m,centre:y,spin:A,gyro:S,airflow:P}=i.coupling,E=Ap(i)&&[m,y,A,S,P],[x,...b]=[...r.pending,o],{x:N,motors:R,rotors:L}=r;function z(H,D,G){let k=d.slew===null?1/0:d.slew*G;R=H.map((Y,ie)=>Math.min(Math.max(Y,R[ie]-k),R[ie]+k));let U=G/_,se=d.lag?Math.exp(-.5*U/d.lag):0,X=Y=>[R[0]+se*(Y[0]-R[0]),R[1]+se*(Y[1]-R[1])];d.lag||(L=R);for(let Y=0;Y<_;Y++){let[ie,ce]=[X(L),X(X(L))],he=D+Y*U,Q=[...Wx(l,he,U),0],ge=i.disturbances.reduce((xe,{loss:Ge,time:qe,duration:ke})=>xe*(1-Ge*Math.min(Math.max((he-qe+.5*U)/ke,0),1)),1),_e=xe=>{let[Ge,qe]=si(xe,e);return ea([t[0]*ge*Ge,t[1]*ge*qe])};N=Ti((xe,Ge)=>{let qe=f===null?zn(xe,Ge,i.parameters):ih(xe,Ge,f),ke=sh(xe,qe,h.viscous,h.coulomb,Q);if(!p&&i.travel_lift===0&&!E)return ke;let it=rh(ah(xe,ke,i.parameters,g),i.travel_lift);return E?oh(xe,it,Math.abs(xe[1]),i.parameters,E):it},N,[_e(L),_e(ie),_e(ce)],U),L=ce}}return n>0&&z(r.arrived,a,n),z(x,a+n,c-n),Xx(i,{...r,x:N,motors:R,rotors:L,arrived:x,pending:b},c)}function Wx(i,e,t){let n=[0,0,0];for(let s of i){let r=a=>Math.min(Math.max(a,0),s.duration),o=r(e+t-s.time)-r(e-s.time);n[s.axis]+=s.acceleration*o/t}return n}function Rp({sensors:i},e){return[e[0],e[2],e[4]].map((t,n)=>i===null?t:lh(t-i.zeros[n],i.counts[n]))}function Xx(i,e,t){let{x:n}=e,s=Rp(i,n);if(i.sensors===null)return{...e,angles:s,rates:[n[1],n[3],n[5]]};let r=Math.exp(-t/i.sensors.rate_filter),o=s.map((a,c)=>r*e.rates[c]+(1-r)*(a-e.angles[c])/t);return{...e,angles:s,rates:o}}var la=class{constructor(e,t,n,s,r){this.controller=e;this.plant=t;this.rules=n;this.ready=ra(t,n.controlPeriod,n.substep),this.state=oa(this.ready,s,r),this.x=[this.state.x]}controller;plant;rules;x;u=[];crashed=!1;state;ready;get rotors(){return this.state.rotors}step(e){if(this.crashed)return;let{controlPeriod:t,amplifier:n,pitchStop:s}=this.rules,r=this.x.length-1,a=this.controller.voltages(r,bh(this.state)).map(d=>di(d,n)),[c,l]=[r*t,(r+1)*t],u=e.filter(({time:d,duration:h})=>d<l&&d+h>c);this.state=aa(this.ready,this.state,a,c,t,u,e.length>0),this.u.push(a),this.x.push(this.state.x),this.crashed=Math.abs(this.state.x[4])>s}};var Cp=4;function Mh(i,[e,t],n,s,r){let{duration:o,goal:a,limits:c}=i,l=s,[u,d]=c.pitch.map(x=>x*(1-n)),[h,f]=c.u.map(x=>si([x,x],l)[0]),p=(x,b)=>x.reduce((N,R,L)=>N+R*(b**(L+2)-b),0);function _(x,[b,,N,R]){let L=4/(d-u),z=.5*(1+Math.tanh(.5*L*N)),H=u+(d-u)*z,D=4*z*(1-z),G=L*D*(1-2*z)*R**2,k=l.a1*Math.sin(b)+l.a2*Math.cos(b),U=l.a3*Math.cos(b)*Math.sin(H),se=di(p(t,x/o),[(U+l.b3*(h-f)-G)/D,(U+l.b3*(f-h)-G)/D]),X=(G+D*se-U)/l.b3,Y=l.b2*Math.cos(H),ie=di(p(e,x/o),[k+Y*(2*f-Math.abs(X)),k+Y*(2*h+Math.abs(X))]);return{y2:H,dy2:D*R,dxi2:se,ddy1:ie,v:[(ie-k)/Y,X]}}function g(x,b){let{y2:N,dxi2:R,ddy1:L,v:z}=_(b,x);return[x[1],L,x[3],R,x[5],l.b1*Math.cos(x[0])*Math.sin(N)*z[0]]}let m=Math.round(o/r),A=[0,0,(d-u)/4*Math.log(-u/d),0,0,0],S=[],P=[],E=r/Cp;for(let x=0;x<=m;x++){let[b,N,,,R,L]=A,{y2:z,dy2:H,v:D}=_(x*r,A);S.push([R,L,b,N,z,H]),P.push(fi(D,l));for(let G=0;G<Cp;G++){let k=x*r+G*E;A=Ti(g,A,[k,k+E/2,k+E],E)}}return S[m]=[a[0],0,a[1],0,0,0],P[m]=fi(Ni(a[1],l),l),{step:r,x:S,u:P}}var Pp=2;function Sh({duration:i,c:e},t,n,s){let r=Qo(e),o=r.length/2-3,a=o/i;function c(m){let y=o*Math.min(Math.max(m/i,0),1),A=Math.min(Math.floor(y),o-1);return uh(y-A).map((S,P)=>{let E=x=>a**P*S.reduce((b,N,R)=>b+N*r[2*(A+R)+x],0);return[E(0),E(1)]})}let l=([m,y],[A,S])=>[m,y,A[0],S[0],A[1],S[1]],u=(m,y)=>{let A=c(y);return[m[1],ch(l(m,A),A[2][0],n)]},d=2*Math.ceil(i/(2*s)-1e-9),h=s/Pp,f=fi(Ni(t[1],n),n),p=[0,0],_=[],g=[];for(let m=0;m<=d;m++){if(m*s>=i-1e-9){_.push([t[0],0,t[1],0,0,0]),g.push(f);continue}let y=c(m*s);_.push(l(p,y)),g.push(fi(Vs(_[m],y[2][0],y[2][1],n),n));for(let A=0;A<Pp;A++){let S=m*s+A*h;p=Ti(u,p,[S,S+h/2,S+h],h)}}return{step:s,x:_,u:g}}var es={lag:{name:"rotor lag",unit:"s",digits:2,min:0,max:.3,step:.01},friction:{name:"friction",unit:"1/s",digits:2,min:0,max:.6,step:.02},loss:{name:"thrust loss",unit:"%",digits:0,min:0,max:30,step:1},delay:{name:"delay",unit:"s",digits:2,min:0,max:.2,step:.01},zero:{name:"pitch zero",unit:"\xB0",digits:0,min:-8,max:8,step:1}},gs=Object.keys(es),xs=["travel","elevation","pitch","effort"],Ip=4,qx=40,yn=(i,e)=>i.rigs.find(t=>t.name===e)??i.rigs[0];function Ws(i,e){let{spline:t,paper:n}=e.grids,s=n?{method:"paper",duration:i.paper.duration,pitchLimit:i.paper.pitch_limit_deg,window:i.paper.window}:{method:"spline",duration:t.durations[3],pitchLimit:50,window:t.windows[Math.min(1,t.windows.length-1)]},r={travel:0,elevation:0,pitch:0,effort:0};return _s({rig:e.name,...s,startOff:3,plant:Object.keys(e.plants)[0],draw:1,effects:{},weights:r},i)}var wh=(i,e)=>i.reduce((t,n,s)=>e(n)<e(i[t])?s:t,0);function ua(i,e){let t=(n,s)=>n===null||s===null?n===s?0:1e3:Math.abs(n-s);return{duration:wh(e.durations,n=>t(n,i.duration)),pitch:wh(e.pitch_limits_deg,n=>Math.abs(n-i.pitchLimit)),window:wh(e.windows,([n,s])=>Math.abs(n-i.window[0])+Math.abs(s-i.window[1]))}}var Xs=(i,e)=>e==="paper"&&i.grids.paper||i.grids.spline;function _s(i,e){let t=yn(e,i.rig),n=i.method==="paper"&&t.grids.paper?"paper":"spline",s=Xs(t,n),r=ua(i,s);return{...i,rig:t.name,method:n,duration:s.durations[r.duration],pitchLimit:s.pitch_limits_deg[r.pitch],window:s.windows[r.window],plant:i.plant in t.plants?i.plant:Object.keys(t.plants)[0],startOff:Math.min(Math.max(Math.round(i.startOff),0),10)}}var ha=(i,e)=>{let t=Xs(yn(e,i.rig),i.method),n=ua(i,t);return t.plans[n.pitch][n.window][n.duration]};function vs(i,e){let t=ha(i,e);return t===null?null:Array.isArray(t)?i.duration:t.duration}function da(i,e){let t=yn(e,i.rig),n=t.plants[i.plant],s=jr(n,Jx(i.draw)),r=JSON.stringify(s)!==JSON.stringify(n),{lag:o,friction:a,loss:c,delay:l,zero:u}=i.effects,d={...s,rotors:{...s.rotors,...o!==void 0&&{lag:o},...c!==void 0&&{thrust_loss:c/100},...l!==void 0&&{delay:l}},friction:a===void 0?s.friction:{...s.friction,viscous:[a,a,a]}};if(u!==void 0){let h=s.sensors??{counts:t.encoder_counts,rate_filter:.03,zeros:[0,0,0]};d.sensors={...h,zeros:h.zeros.with(2,mr(u))}}return{plant:d,isRandom:r}}function Qr({rotors:i,friction:e,sensors:t}){return{lag:i.lag,friction:e.viscous.reduce((n,s)=>n+s/3,0),loss:100*i.thrust_loss,delay:i.delay,zero:$t(t?.zeros[2]??0)}}var ca=new Map,Th=new WeakMap,Yx=0;function $x(i){return Th.has(i)||Th.set(i,Yx++),Th.get(i)}function Lp({weights:i},e,t){let n=[i.travel,i.travel,i.elevation,i.elevation,i.pitch,i.pitch].map(o=>10**o),s=e.weights.Q.map((o,a)=>o.map(c=>n[a]*c)),r=e.weights.R.map(o=>o.map(a=>10**i.effort*a));return _h({Q:s,R:r},t[1],e.parameters)}function Zx(i,e,t,n){let s=n?null:ha(i,e);if(!n&&s===null)return null;let r=JSON.stringify([t.name,i.method,i.duration,i.pitchLimit,i.window,i.weights,n&&$x(n)]),o=ca.get(r);if(o)return o;let a=eo(i),c=e.control_period/2,l=n?{step:n.step,x:n.x,u:n.u}:Array.isArray(s)?Mh({duration:i.duration,goal:e.goal,limits:a},[s.slice(0,e.kappa[0]),s.slice(e.kappa[0])],e.pitch_reserve,t.parameters,c):Sh(s,e.goal,t.parameters,c),u,d={...t,control_period:e.control_period,features:e.features,get yours(){return u??=Lp(i,t,e.goal)}},h=Object.fromEntries(Object.entries(t.networks).map(([p,_])=>[p,xh(_)])),f={plan:l,controllers:yh(l,a.pitch,d),networks:h};return ca.set(r,f),ca.size>qx&&ca.delete(ca.keys().next().value),f}function eo({pitchLimit:i,window:e}){return{u:e,pitch:[-mr(i),mr(i)]}}var yr=class i{constructor(e,t,n,s){this.setup=e;this.log=n;this.ready=s;this.rig=yn(t,e.rig),{plant:this.plant,isRandom:this.isRandom}=da(e,t);let r=t.control_period,o=na(s.plan),a=o.x.length-1;this.duration=r*a;let c=Array.from({length:a+1+(n?0:Math.round(Ip/r))},(u,d)=>Math.min(d,a));this.reference={x:c.map(u=>o.x[u]),u:c.map(u=>o.u[u]),middle:c.map(u=>o.middle[u])},this.rules={controlPeriod:r,amplifier:this.rig.amplifier,pitchStop:this.rig.pitch_stop,substep:t.substep};let l=n?0:mr(e.startOff);this.start=this.reference.x[0].map((u,d)=>u+(d===0?-l:d===2?l:0)),this.rest=n?n.u[0]:fi(Ni(0,this.rig.parameters),this.rig.parameters)}setup;log;ready;rig;plant;isRandom;reference;duration;rules;start;rest;static make(e,t,n=null){let s=Zx(e,t,yn(t,e.rig),n);return s&&new i(e,t,n,s)}get steps(){return this.reference.x.length-1}get network(){return this.ready.networks[this.rig.network_for[this.setup.plant]]}offers(e){return e!=="residual"||this.network.learned!==null}begin(e){let t=this.ready.controllers[e](this.network);return t&&new la(t,this.plant,this.rules,this.start,this.rest)}fly(e,t=[]){let n=this.begin(e);for(;n&&!n.crashed&&n.x.length<=this.steps;)n.step(t);return n}gains(e){let{controller:t}=this.begin(e)??{};return t&&"tracking"in t&&t.tracking.gains||null}endError(e){if(e.crashed)return 1/0;let[t,n]=[e.x[Math.round(this.duration/this.rules.controlPeriod)],this.reference.x.at(-1)];return $t(Math.hypot(t[0]-n[0],t[2]-n[2]))}rmsError(e){if(e.crashed)return 1/0;let t=e.x.map((n,s)=>(n[0]-this.reference.x[s][0])**2+(n[2]-this.reference.x[s][2])**2);return $t(Math.sqrt(t.reduce((n,s)=>n+s,0)/t.length))}saturation(e){let[t,n]=this.rig.amplifier;return e.u.filter(r=>r.some(o=>o<=t+1e-9||o>=n-1e-9)).length/Math.max(e.u.length,1)}};function Jx(i){let e=i>>>0;return()=>{e=e+1831565813>>>0;let t=Math.imul(e^e>>>15,1|e);return t=t+Math.imul(t^t>>>7,61|t)^t,((t^t>>>14)>>>0)/4294967296}}function Sl(i,e){let t=URL.createObjectURL(e);J("a",{href:t,download:i}).click(),setTimeout(()=>URL.revokeObjectURL(t),1e3)}function Eh(i,e,t){let n=["travel","elevation","pitch"],r=["t",...[...i.map(([a])=>a),"plan"].flatMap(a=>[...n.map(c=>`${a} ${c}_deg`),`${a} u_front`,`${a} u_back`])],o=e.x.map((a,c)=>{let u=[...i.map(([,{x:d,u:h}])=>[d[c],h[Math.min(c,h.length-1)]]),[a,e.u[c]]].flatMap(([d,h])=>d&&h?[...[d[0],d[2],d[4]].map($t),...h].map(f=>f.toFixed(6)):["","","","",""]);return[(c*t).toFixed(4),...u].join(",")});return[r.map(a=>/[",]/.test(a)?`"${a.replaceAll('"','""')}"`:a).join(","),...o,""].join(`
`)}function Ah(i,e,t,n){let[r,o,a]=[1200,16,170],c=3,l=Math.round(r*i.clientHeight/Math.max(i.clientWidth,1)),u=Math.ceil(t.length/c),d=J("canvas",{width:2*r,height:2*(40+l+u*(a+26)+o)}),h=d.getContext("2d");h.scale(2,2);let f=(_,g,m,y=400)=>{h.font=`${y} 13px system-ui, sans-serif`,h.fillText(_,g,m)};h.fillStyle=hi("paper"),h.fillRect(0,0,r,d.height),h.drawImage(i,0,40,r,l),h.fillStyle=hi("ink"),f(n,o,26,600);let p=i.getBoundingClientRect();for(let _ of e){let g=_.getBoundingClientRect(),m=r/p.width,[y,A]=[(g.left-p.left)*m+o,40+(g.top-p.top)*m];f(_.querySelector(".name").textContent,y,A+22,600),f([..._.querySelectorAll(".numbers span")].map(S=>S.textContent).join("   "),y,A+g.height*m-10)}return t.forEach((_,g)=>{let m=o+g%c*((r-o)/c),y=40+l+Math.floor(g/c)*(a+26);f(`${_.options.title} (${_.options.unit})`,m,y+20,600),h.drawImage(_.canvas,m,y+26,(r-o)/c-o,a)}),d}var Kx=/^(t|time|zeit)\b/i,jx=[/travel/i,/elev/i,/pitch/i,/(u|v|volt\w*)[ _-]*f|front/i,/(u|v|volt\w*)[ _-]*b|back|rear/i],Qx=["travel","elevation","pitch","front voltage","back voltage"],e_=/ref|plan|rate|des|target|set/i,Dp=4;function Rh(i,e,t){let n=i.split(/\r?\n/).filter(b=>b.trim()&&!b.startsWith("#"));if(n.length<3)throw new Error(`${e}: must have a line of names and at least two of numbers`);let s=[",",";","	"].find(b=>n[0].includes(b))??",",r=n[0].split(s).map(b=>b.trim().replaceAll('"',"")),o=(b,N)=>{let R=r.findIndex(L=>b.test(L)&&!e_.test(L));if(R<0)throw new Error(`${e}: must have a column for ${N}; it has ${r.join(", ")}`);return R},[a,...c]=[o(Kx,"the time"),...jx.map((b,N)=>o(b,Qx[N]))],l=n.slice(1).map(b=>b.split(s).map(Number)),u=[a,...c],d=l.filter(b=>u.every(N=>Number.isFinite(b[N]))),h=d.map(b=>b[a]-d[0][a]);if(d.length<2||!h.every((b,N)=>N===0||b>h[N-1]))throw new Error(`${e}: must have numbers, and times that rise from line to line`);let f=c.map(b=>/deg|°/i.test(r[b])?mr(1):1),p=c.map((b,N)=>d.map(R=>R[b]*f[N])),_=(b,N)=>{let R=Math.min(Math.floor(N/h.at(-1)*(h.length-1)),h.length-2);for(;R>0&&h[R]>N;)R--;for(;R<h.length-2&&h[R+1]<=N;)R++;let L=Math.min(Math.max((N-h[R])/(h[R+1]-h[R]),0),1);return b[R]+L*(b[R+1]-b[R])},g=2*Math.floor(h.at(-1)/(2*t)),m=Array.from({length:g+1},(b,N)=>N*t),[y,A,S,P,E]=p.map(b=>m.map(N=>_(b,N))),x=[y,A,S].map(b=>t_(b,t));return{name:e,step:t,x:m.map((b,N)=>[y[N],x[0][N],A[N],x[1][N],S[N],x[2][N]]),u:m.map((b,N)=>[P[N],E[N]])}}function t_(i,e){return i.map((t,n)=>{let[s,r]=[Math.max(n-Dp,0),Math.min(n+Dp,i.length-1)],o=.5*(s+r),[a,c]=[0,0];for(let l=s;l<=r;l++)a+=(l-o)*i[l],c+=(l-o)**2;return a/c/e})}function Ch(i,e,t){let n=ra({...e,disturbances:[]},t.controlPeriod,t.substep),s=Math.round(t.controlPeriod/i.step),r=Math.round(1/t.controlPeriod),o=[0,0,0],a=0;for(let c=0;c+r*s<i.x.length;c+=r*s/2){let l=oa(n,i.x[c],i.u[c]);for(let u=0;u<r;u++)l=aa(n,l,i.u[c+u*s],0,t.controlPeriod,[],!1);[0,2,4].forEach((u,d)=>o[d]+=(l.x[u]-i.x[c+r*s][u])**2),a+=1}return o.map(c=>$t(Math.sqrt(c/Math.max(a,1))))}function Ph(i,e,t){let n=Ws(t,yn(t,i.rig)),s=new URLSearchParams,r=(a,c,l)=>{`${c}`!=`${l}`&&s.set(a,`${c}`)};r("rig",i.rig,t.rigs[0].name),r("plan",i.method,n.method),r("T",i.duration??"fastest",n.duration),r("pitch",i.pitchLimit,n.pitchLimit),r("window",i.window.join("~"),n.window.join("~")),r("off",i.startOff,n.startOff),r("plant",i.plant,n.plant),r("draw",i.draw,n.draw);for(let a of gs)i.effects[a]!==void 0&&s.set(a,`${i.effects[a]}`);r("weights",xs.map(a=>i.weights[a]).join("~"),xs.map(()=>0).join("~")),r("show",e.join("~"),Ih(t).join("~"));let o=s.toString();return o?`#${o}`:""}var Ih=i=>i.policies.filter(({shown:e})=>e).map(({name:e})=>e),Np=(i,e,t)=>Math.min(Math.max(i,e),t);function wl(i,e){let t=new URLSearchParams(i.replace(/^#/,"")),n=Ws(e,yn(e,t.get("rig")??"")),s=(u,d)=>{let h=Number(t.get(u)?.trim()||Number.NaN);return Number.isFinite(h)?h:d},r=(u,d)=>{let h=(t.get(u)??"").split("~").map(Number);return h.length===d&&h.every(Number.isFinite)?h:null},o=r("weights",xs.length)??xs.map(()=>0),a={...n,method:t.get("plan")==="spline"?"spline":t.get("plan")==="paper"?"paper":n.method,duration:t.get("T")==="fastest"?null:s("T",n.duration??Number.NaN)||n.duration,pitchLimit:s("pitch",n.pitchLimit),window:r("window",2)??n.window,startOff:s("off",n.startOff),plant:t.get("plant")??n.plant,draw:Math.max(1,Math.round(s("draw",n.draw))),effects:Object.fromEntries(gs.map(u=>[u,s(u,Number.NaN)]).filter(([,u])=>Number.isFinite(u)).map(([u,d])=>[u,Np(d,es[u].min,es[u].max)])),weights:Object.fromEntries(xs.map((u,d)=>[u,Np(o[d],-2,2)]))},c=e.policies.map(({name:u})=>u),l=t.has("show")?t.get("show").split("~").filter(u=>c.includes(u)):Ih(e);return{setup:_s(a,e),shown:l}}var n_="http://www.w3.org/1998/Math/MathML";function ts(i,...e){let t=document.createElementNS(n_,i);return t.append(...e),t}function qs(i){if(/^[\d.]+$/.test(i))return ts("mn",i);if(/^[\p{L}\p{M}]+$/u.test(i))return ts("mi",i);let e=ts("mo",i);return e.setAttribute("stretchy","false"),e}function Up(){let i=ts("mspace");return i.setAttribute("width","0.17em"),i}function Fp(i){let e=i.split(" ").flatMap(n=>{if(/^(sin|cos|sgn)$/.test(n))return[Up(),ts("mi",n),Up()];let[,s,r,o]=/^([^_^]+)(?:_([^^]+))?(?:\^(.+))?$/.exec(n);return r&&o?ts("msubsup",qs(s),qs(r),qs(o)):r?ts("msub",qs(s),qs(r)):o?ts("msup",qs(s),qs(o)):qs(s)}),t=ts("math",ts("mrow",...e));return t.setAttribute("display","block"),J("div",{class:"equation"},t)}var i_="uplot",s_="u-hz",r_="u-vt",o_="u-title",a_="u-wrap",l_="u-under",c_="u-over",u_="u-axis",Sr="u-off",h_="u-select",d_="u-cursor-x",f_="u-cursor-y",p_="u-cursor-pt",m_="u-legend",g_="u-live",x_="u-inline",__="u-series",v_="u-marker",Op="u-label",y_="u-value",pa="width",ma="height";var Bp="bottom",to="left",Lh="right",Zh="#000",kp=Zh+"0",Dh="mousemove",zp="mousedown",Nh="mouseup",Gp="mouseenter",Vp="mouseleave",Hp="dblclick",b_="resize",M_="scroll",Wp="change",Cl="dppxchange",Jh="--",lo=typeof window<"u",kh=lo?document:null,io=lo?window:null,S_=lo?navigator:null,Ut,Tl;function zh(){let i=devicePixelRatio;Ut!=i&&(Ut=i,Tl&&Vh(Wp,Tl,zh),Tl=matchMedia(`(min-resolution: ${Ut-.001}dppx) and (max-resolution: ${Ut+.001}dppx)`),wr(Wp,Tl,zh),io.dispatchEvent(new CustomEvent(Cl)))}function pi(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function Gh(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function nn(i,e,t){i.style[e]=t+"px"}function Ui(i,e,t,n){let s=kh.createElement(i);return e!=null&&pi(s,e),t?.insertBefore(s,n),s}function Ei(i,e){return Ui("div",i,e)}var Xp=new WeakMap;function ns(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=Xp.get(i);r!=o&&(i.style.transform=r,Xp.set(i,r),e<0||t<0||e>n||t>s?pi(i,Sr):Gh(i,Sr))}var qp=new WeakMap;function Yp(i,e,t){let n=e+t,s=qp.get(i);n!=s&&(qp.set(i,n),i.style.background=e,i.style.borderColor=t)}var $p=new WeakMap;function Zp(i,e,t,n){let s=e+""+t,r=$p.get(i);s!=r&&($p.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var Kh={passive:!0},w_={...Kh,capture:!0};function wr(i,e,t,n){e.addEventListener(i,t,n?w_:Kh)}function Vh(i,e,t,n){e.removeEventListener(i,t,Kh)}lo&&zh();function Fi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:mi((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function Sm(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var wm=i=>i!=null,Tm=i=>i!=null&&i>0,Ll=Sm(wm),T_=Sm(Tm);function E_(i,e,t,n=0,s=!1){let r=s?T_:Ll,o=s?Tm:wm;[e,t]=r(i,e,t);let a=i[e],c=i[e];if(e>-1)if(n==1)a=i[e],c=i[t];else if(n==-1)a=i[t],c=i[e];else for(let l=e;l<=t;l++){let u=i[l];o(u)&&(u<a?a=u:u>c&&(c=u))}return[a??Zt,c??-Zt]}function Dl(i,e,t,n){let s=jp(i),r=jp(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?ys:Em,a=s==1?mi:Ai,c=r==1?Ai:mi,l=a(o(Tn(i))),u=c(o(Tn(e))),d=so(t,l),h=so(t,u);return t==10&&(l<0&&(d=Jt(d,-l)),u<0&&(h=Jt(h,-u))),n||t==2?(i=d*s,e=h*r):(i=Pm(i,d),e=Nl(e,h)),[i,e]}function jh(i,e,t,n){let s=Dl(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var Qh=.1,Jp={mode:3,pad:Qh},xa={pad:0,soft:null,mode:0},A_={min:xa,max:xa};function Pl(i,e,t,n){return Ul(t)?Kp(i,e,t):(xa.pad=t,xa.soft=n?0:null,xa.mode=n?3:0,Kp(i,e,A_))}function Dt(i,e){return i??e}function R_(i,e,t){for(e=Dt(e,0),t=Dt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Kp(i,e,t){let n=t.min,s=t.max,r=Dt(n.pad,0),o=Dt(s.pad,0),a=Dt(n.hard,-Zt),c=Dt(s.hard,Zt),l=Dt(n.soft,Zt),u=Dt(s.soft,-Zt),d=Dt(n.mode,0),h=Dt(s.mode,0),f=e-i,p=ys(f),_=Jn(Tn(i),Tn(e)),g=ys(_),m=Tn(g-p);(f<1e-24||m>10)&&(f=0,(i==0||e==0)&&(f=1e-24,d==2&&l!=Zt&&(r=0),h==2&&u!=-Zt&&(o=0)));let y=f||_||1e3,A=ys(y),S=so(10,mi(A)),P=y*(f==0?i==0?.1:1:r),E=Jt(Pm(i-P,S/10),24),x=i>=l&&(d==1||d==3&&E<=l||d==2&&E>=l)?l:Zt,b=Jn(a,E<x&&i>=x?x:Oi(x,E)),N=y*(f==0?e==0?.1:1:o),R=Jt(Nl(e+N,S/10),24),L=e<=u&&(h==1||h==3&&R>=u||h==2&&R<=u)?u:-Zt,z=Oi(c,R>L&&e<=L?L:Jn(L,R));return b==z&&b==0&&(z=100),[b,z]}var C_=new Intl.NumberFormat(lo?S_.language:"en-US"),ed=i=>C_.format(i),gi=Math,Rl=gi.PI,Tn=gi.abs,mi=gi.floor,wn=gi.round,Ai=gi.ceil,Oi=gi.min,Jn=gi.max,so=gi.pow,jp=gi.sign,ys=gi.log10,Em=gi.log2,P_=(i,e=1)=>gi.sinh(i)*e,Uh=(i,e=1)=>gi.asinh(i/e),Zt=1/0;function Qp(i){return(ys((i^i>>31)-(i>>31))|0)+1}function Hh(i,e,t){return Oi(Jn(i,e),t)}function Am(i){return typeof i=="function"}function At(i){return Am(i)?i:()=>i}var I_=()=>{},Rm=i=>i,Cm=(i,e)=>e,L_=i=>null,em=i=>!0,tm=(i,e)=>i==e,D_=/\.\d*?(?=9{6,}|0{6,})/gm,Tr=i=>{if(Lm(i)||$s.has(i))return i;let e=`${i}`,t=e.match(D_);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Tr(s)}e${r}`}return Jt(i,n)};function br(i,e){return Tr(Jt(Tr(i/e))*e)}function Nl(i,e){return Tr(Ai(Tr(i/e))*e)}function Pm(i,e){return Tr(mi(Tr(i/e))*e)}function Jt(i,e=0){if(Lm(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return wn(n)/t}var $s=new Map;function Im(i){return((""+i).split(".")[1]||"").length}function va(i,e,t,n){let s=[],r=n.map(Im);for(let o=e;o<t;o++){let a=Tn(o),c=Jt(so(i,o),a);for(let l=0;l<n.length;l++){let u=i==10?+`${n[l]}e${o}`:n[l]*c,d=(o>=0?0:a)+(o>=r[l]?0:r[l]),h=i==10?u:Jt(u,d);s.push(h),$s.set(h,d)}}return s}var _a={},td=[],ro=[null,null],Ys=Array.isArray,Lm=Number.isInteger,N_=i=>i===void 0;function nm(i){return typeof i=="string"}function Ul(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function U_(i){return i!=null&&typeof i=="object"}var F_=Object.getPrototypeOf(Uint8Array),Dm="__proto__";function oo(i,e=Ul){let t;if(Ys(i)){let n=i.find(s=>s!=null);if(Ys(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=oo(i[s],e)}else t=i.slice()}else if(i instanceof F_)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Dm&&(t[n]=oo(i[n],e))}else t=i;return t}function bn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Dm&&(Ul(i[s])?bn(i[s],oo(n[s])):i[s]=oo(n[s]))}return i}var O_=0,B_=1,k_=2;function z_(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function G_(i,e){if(W_(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return X_(o[0])||(o=H_(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let c=i[o][0],l=c.length;for(let u=0;u<l;u++)t.add(c[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],c=a[0];for(let l=1;l<a.length;l++){let u=a[l],d=Array(s).fill(void 0),h=e?e[o][l]:B_,f=[];for(let p=0;p<u.length;p++){let _=u[p],g=r.get(c[p]);_===null?h!=O_&&(d[g]=_,h==k_&&f.push(g)):d[g]=_}z_(d,f,s),n.push(d)}}return n}var V_=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function H_(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let c=0;c<t;c++)a[c]=o[n[c]];s.push(a)}return s}function W_(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function X_(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Jn(1,mi((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let c=i[a];if(c!=null){if(c<=o)return!1;o=c}}return!0}var Nm=["January","February","March","April","May","June","July","August","September","October","November","December"],Um=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Fm(i){return i.slice(0,3)}var q_=Um.map(Fm),Y_=Nm.map(Fm),$_={MMMM:Nm,MMM:Y_,WWWW:Um,WWW:q_};function fa(i){return(i<10?"0":"")+i}function Z_(i){return(i<10?"00":i<100?"0":"")+i}var J_={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>fa(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>fa(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>fa(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>fa(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>fa(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Z_(i.getMilliseconds())};function nd(i,e){e=e||$_;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?J_[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var K_=new Intl.DateTimeFormat().resolvedOptions().timeZone;function j_(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==K_?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Om=i=>i%1==0,Il=[1,2,2.5,5],Q_=va(10,-32,0,Il),Bm=va(10,0,32,Il),ev=Bm.filter(Om),Mr=Q_.concat(Bm),id=`
`,km="{YYYY}",im=id+km,zm="{M}/{D}",ga=id+zm,El=ga+"/{YY}",Gm="{aa}",tv="{h}:{mm}",no=tv+Gm,sm=id+no,rm=":{ss}",Bt=null;function Vm(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,c=(i==1?va(10,0,3,Il).filter(Om):va(10,-3,0,Il)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),l=[[o,km,Bt,Bt,Bt,Bt,Bt,Bt,1],[s*28,"{MMM}",im,Bt,Bt,Bt,Bt,Bt,1],[s,zm,im,Bt,Bt,Bt,Bt,Bt,1],[n,"{h}"+Gm,El,Bt,ga,Bt,Bt,Bt,1],[t,no,El,Bt,ga,Bt,Bt,Bt,1],[e,rm,El+" "+no,Bt,ga+" "+no,Bt,sm,Bt,1],[i,rm+".{fff}",El+" "+no,Bt,ga+" "+no,Bt,sm,Bt,1]];function u(d){return(h,f,p,_,g,m)=>{let y=[],A=g>=o,S=g>=r&&g<o,P=d(p),E=Jt(P*i,3),x=Fh(P.getFullYear(),A?0:P.getMonth(),S||A?1:P.getDate()),b=Jt(x*i,3);if(S||A){let N=S?g/r:0,R=A?g/o:0,L=E==b?E:Jt(Fh(x.getFullYear()+R,x.getMonth()+N,1)*i,3),z=new Date(wn(L/i)),H=z.getFullYear(),D=z.getMonth();for(let G=0;L<=_;G++){let k=Fh(H+R*G,D+N*G,1),U=k-d(Jt(k*i,3));L=Jt((+k+U)*i,3),L<=_&&y.push(L)}}else{let N=g>=s?s:g,R=mi(p)-mi(E),L=b+R+Nl(E-b,N);y.push(L);let z=d(L),H=z.getHours()+z.getMinutes()/t+z.getSeconds()/n,D=g/n,G=h.axes[f]._space,k=m/G;for(;L=Jt(L+g,i==1?0:3),!(L>_);)if(D>1){let U=mi(Jt(H+D,6))%24,Y=d(L).getHours()-U;Y>1&&(Y=-1),L-=Y*n,H=(H+D)%24;let ie=y[y.length-1];Jt((L-ie)/g,3)*k>=.7&&y.push(L)}else y.push(L)}return y}}return[c,l,u]}var[nv,iv,sv]=Vm(1),[rv,ov,av]=Vm(.001);va(2,-53,53,[1]);function om(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function am(i,e){return(t,n,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],c,l,u,d,h,f;return n.map(p=>{let _=i(p),g=_.getFullYear(),m=_.getMonth(),y=_.getDate(),A=_.getHours(),S=_.getMinutes(),P=_.getSeconds(),E=g!=c&&a[2]||m!=l&&a[3]||y!=u&&a[4]||A!=d&&a[5]||S!=h&&a[6]||P!=f&&a[7]||a[1];return c=g,l=m,u=y,d=A,h=S,f=P,E(_)})}}function lv(i,e){let t=nd(e);return(n,s,r,o,a)=>s.map(c=>t(i(c)))}function Fh(i,e,t){return new Date(i,e,t)}function lm(i,e){return e(i)}var cv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function cm(i,e){return(t,n,s,r)=>r==null?Jh:e(i(n))}function uv(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function hv(i,e){return i.series[e].fill(i,e)}var dv={show:!0,live:!0,isolate:!1,mount:I_,markers:{show:!0,width:2,stroke:uv,fill:hv,dash:"solid"},idx:null,idxs:null,values:[]};function fv(i,e){let t=i.cursor.points,n=Ei(),s=t.size(i,e);nn(n,pa,s),nn(n,ma,s);let r=s/-2;nn(n,"marginLeft",r),nn(n,"marginTop",r);let o=t.width(i,e,s);return o&&nn(n,"borderWidth",o),n}function pv(i,e){let t=i.series[e].points;return t._fill||t._stroke}function mv(i,e){let t=i.series[e].points;return t._stroke||t._fill}function gv(i,e){return i.series[e].points.size}var Oh=[0,0];function xv(i,e,t){return Oh[0]=e,Oh[1]=t,Oh}function Al(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function Bh(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var _v={show:!0,x:!0,y:!0,lock:!1,move:xv,points:{one:!1,show:fv,size:gv,width:0,stroke:mv,fill:pv},bind:{mousedown:Al,mouseup:Al,click:Al,dblclick:Al,mousemove:Bh,mouseleave:Bh,mouseenter:Bh},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Hm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},sd=bn({},Hm,{filter:Cm}),Wm=bn({},sd,{size:10}),Xm=bn({},Hm,{show:!1}),rd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',qm="bold "+rd,Ym=1.5,um={show:!0,scale:"x",stroke:Zh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:qm,side:2,grid:sd,ticks:Wm,border:Xm,font:rd,lineGap:Ym,rotate:0},vv="Value",yv="Time",hm={show:!0,scale:"x",auto:!1,sorted:1,min:Zt,max:-Zt,idxs:[]};function bv(i,e,t,n,s){return e.map(r=>r==null?"":ed(r))}function Mv(i,e,t,n,s,r,o){let a=[],c=$s.get(s)||0;t=o?t:Jt(Nl(t,s),c);for(let l=t;l<=n;l=Jt(l+s,c))a.push(Object.is(l,-0)?0:l);return a}function Wh(i,e,t,n,s,r,o){let a=[],c=i.scales[i.axes[e].scale].log,l=c==10?ys:Em,u=mi(l(t));s=so(c,u),c==10&&(s=Mr[Fi(s,Mr)]);let d=t,h=s*c;c==10&&(h=Mr[Fi(h,Mr)]);do a.push(d),d=d+s,c==10&&!$s.has(d)&&(d=Jt(d,$s.get(s))),d>=h&&(s=d,h=s*c,c==10&&(h=Mr[Fi(h,Mr)]));while(d<=n);return a}function Sv(i,e,t,n,s,r,o){let c=i.scales[i.axes[e].scale].asinh,l=n>c?Wh(i,e,Jn(c,t),n,s):[c],u=n>=0&&t<=0?[0]:[];return(t<-c?Wh(i,e,Jn(c,-n),-t,s):[c]).reverse().map(h=>-h).concat(u,l)}var $m=/./,wv=/[12357]/,Tv=/[125]/,dm=/1/,Xh=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Ev(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],c=i.valToPos,l=r._space,u=c(10,o),d=c(9,o)-u>=l?$m:c(7,o)-u>=l?wv:c(5,o)-u>=l?Tv:dm;if(d==dm){let h=Tn(c(1,o)-u);if(h<l)return Xh(e.slice().reverse(),a.distr,d,Ai(l/h)).reverse()}return Xh(e,a.distr,d,1)}function Av(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,c=i.valToPos,l=Tn(c(1,o)-c(2,o));return l<a?Xh(e.slice().reverse(),3,$m,Ai(a/l)).reverse():e}function Rv(i,e,t,n){return n==null?Jh:e==null?"":ed(e)}var fm={show:!0,scale:"y",stroke:Zh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:qm,side:3,grid:sd,ticks:Wm,border:Xm,font:rd,lineGap:Ym,rotate:0};function Cv(i,e){let t=3+(i||1)*2;return Jt(t*e,3)}function Pv(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=Tn(o-r),c=i.series[e],l=a/(c.points.space*Ut);return n[1]-n[0]<=l}var pm={scale:null,auto:!0,sorted:0,min:Zt,max:-Zt},Zm=(i,e,t,n,s)=>s,mm={show:!0,auto:!0,sorted:0,gaps:Zm,alpha:1,facets:[bn({},pm,{scale:"x"}),bn({},pm,{scale:"y"})]},gm={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Zm,alpha:1,points:{show:Pv,filter:null},values:null,min:Zt,max:-Zt,idxs:[],path:null,clip:null};function Iv(i,e,t,n,s){return t/10}var Jm={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Lv=bn({},Jm,{time:!1,ori:1}),xm={};function Km(i,e){let t=xm[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,c,l){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,c,l)}},i!=null&&(xm[i]=t)),t}var ao=1,qh=2;function Er(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,c=r[0],l=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],d=n==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,p=a.width,_=a.height,g=i.valToPosH,m=i.valToPosV;return u.ori==0?t(s,c,l,u,d,g,m,h,f,p,_,Ol,co,kl,Qm,tg):t(s,c,l,u,d,m,g,f,h,_,p,Bl,uo,ld,eg,ng)}function od(i,e){let t=0,n=0,s=Dt(i.bands,td);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Dv(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,c=i.scales[a];return s==-1?c.min:s==1?c.max:c.distr==3?c.dir==1?c.min:c.max:0}function bs(i,e,t,n,s,r){return Er(i,e,(o,a,c,l,u,d,h,f,p,_,g)=>{let m=o.pxRound,y=l.dir*(l.ori==0?1:-1),A=l.ori==0?co:uo,S,P;y==1?(S=t,P=n):(S=n,P=t);let E=m(d(a[S],l,_,f)),x=m(h(c[S],u,g,p)),b=m(d(a[P],l,_,f)),N=m(h(r==1?u.max:u.min,u,g,p)),R=new Path2D(s);return A(R,b,N),A(R,E,N),A(R,E,x),R})}function Fl(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?kl:ld,c=t;for(let d=0;d<i.length;d++){let h=i[d];if(h[1]>h[0]){let f=h[0]-c;f>0&&a(o,c,n,f,n+r),c=h[1]}}let l=t+s-c,u=10;l>0&&a(o,c,n-u/2,l,n+r+u)}return o}function Nv(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function ad(i,e,t,n,s,r,o){let a=[],c=i.length;for(let l=s==1?t:n;l>=t&&l<=n;l+=s)if(e[l]===null){let d=l,h=l;if(s==1)for(;++l<=n&&e[l]===null;)h=l;else for(;--l>=t&&e[l]===null;)h=l;let f=r(i[d]),p=h==d?f:r(i[h]),_=d-s;f=o<=0&&_>=0&&_<c?r(i[_]):f;let m=h+s;p=o>=0&&m>=0&&m<c?r(i[m]):p,p>=f&&a.push([f,p])}return a}function _m(i){return i==0?Rm:i==1?wn:e=>br(e,i)}function jm(i){let e=i==0?Ol:Bl,t=i==0?(s,r,o,a,c,l)=>{s.arcTo(r,o,a,c,l)}:(s,r,o,a,c,l)=>{s.arcTo(o,r,c,a,l)},n=i==0?(s,r,o,a,c)=>{s.rect(r,o,a,c)}:(s,r,o,a,c)=>{s.rect(o,r,c,a)};return(s,r,o,a,c,l=0,u=0)=>{l==0&&u==0?n(s,r,o,a,c):(l=Oi(l,a/2,c/2),u=Oi(u,a/2,c/2),e(s,r+l,o),t(s,r+a,o,r+a,o+c,l),t(s,r+a,o+c,r,o+c,u),t(s,r,o+c,r,o,u),t(s,r,o,r+a,o,l),s.closePath())}}var Ol=(i,e,t)=>{i.moveTo(e,t)},Bl=(i,e,t)=>{i.moveTo(t,e)},co=(i,e,t)=>{i.lineTo(e,t)},uo=(i,e,t)=>{i.lineTo(t,e)},kl=jm(0),ld=jm(1),Qm=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},eg=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},tg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},ng=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function ig(i){return(e,t,n,s,r)=>Er(e,t,(o,a,c,l,u,d,h,f,p,_,g)=>{let{pxRound:m,points:y}=o,A,S;l.ori==0?(A=Ol,S=Qm):(A=Bl,S=eg);let P=Jt(y.width*Ut,3),E=(y.size-y.width)/2*Ut,x=Jt(E*2,3),b=new Path2D,N=new Path2D,{left:R,top:L,width:z,height:H}=e.bbox;kl(N,R-x,L-x,z+x*2,H+x*2);let D=G=>{if(c[G]!=null){let k=m(d(a[G],l,_,f)),U=m(h(c[G],u,g,p));A(b,k+E,U),S(b,k,U,E,0,Rl*2)}};if(r)r.forEach(D);else for(let G=n;G<=s;G++)D(G);return{stroke:P>0?b:null,fill:b,clip:N,flags:ao|qh}})}function sg(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var Uv=sg(co),Fv=sg(uo);function rg(i){let e=Dt(i?.alignGaps,0);return(t,n,s,r)=>Er(t,n,(o,a,c,l,u,d,h,f,p,_,g)=>{[s,r]=Ll(c,s,r);let m=o.pxRound,y=H=>m(d(H,l,_,f)),A=H=>m(h(H,u,g,p)),S,P;l.ori==0?(S=co,P=Uv):(S=uo,P=Fv);let E=l.dir*(l.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ao},b=x.stroke,N=!1;if(r-s>=_*4){let H=he=>t.posToVal(he,l.key,!0),D=null,G=null,k,U,se,X=y(a[E==1?s:r]),Y=y(a[s]),ie=y(a[r]),ce=H(E==1?Y+1:ie-1);for(let he=E==1?s:r;he>=s&&he<=r;he+=E){let Q=a[he],_e=(E==1?Q<ce:Q>ce)?X:y(Q),Te=c[he];_e==X?Te!=null?(U=Te,D==null?(S(b,_e,A(U)),k=D=G=U):U<D?D=U:U>G&&(G=U)):Te===null&&(N=!0):(D!=null&&P(b,X,A(D),A(G),A(k),A(U)),Te!=null?(U=Te,S(b,_e,A(U)),D=G=k=U):(D=G=null,Te===null&&(N=!0)),X=_e,ce=H(X+E))}D!=null&&D!=G&&se!=X&&P(b,X,A(D),A(G),A(k),A(U))}else for(let H=E==1?s:r;H>=s&&H<=r;H+=E){let D=c[H];D===null?N=!0:D!=null&&S(b,y(a[H]),A(D))}let[L,z]=od(t,n);if(o.fill!=null||L!=0){let H=x.fill=new Path2D(b),D=o.fillTo(t,n,o.min,o.max,L),G=A(D),k=y(a[s]),U=y(a[r]);E==-1&&([U,k]=[k,U]),S(H,U,G),S(H,k,G)}if(!o.spanGaps){let H=[];N&&H.push(...ad(a,c,s,r,E,y,e)),x.gaps=H=o.gaps(t,n,s,r,H),x.clip=Fl(H,l.ori,f,p,_,g)}return z!=0&&(x.band=z==2?[bs(t,n,s,r,b,-1),bs(t,n,s,r,b,1)]:bs(t,n,s,r,b,z)),x})}function Ov(i){let e=Dt(i.align,1),t=Dt(i.ascDesc,!1),n=Dt(i.alignGaps,0),s=Dt(i.extend,!1);return(r,o,a,c)=>Er(r,o,(l,u,d,h,f,p,_,g,m,y,A)=>{[a,c]=Ll(d,a,c);let S=l.pxRound,{left:P,width:E}=r.bbox,x=Y=>S(p(Y,h,y,g)),b=Y=>S(_(Y,f,A,m)),N=h.ori==0?co:uo,R={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ao},L=R.stroke,z=h.dir*(h.ori==0?1:-1),H=b(d[z==1?a:c]),D=x(u[z==1?a:c]),G=D,k=D;s&&e==-1&&(k=P,N(L,k,H)),N(L,D,H);for(let Y=z==1?a:c;Y>=a&&Y<=c;Y+=z){let ie=d[Y];if(ie==null)continue;let ce=x(u[Y]),he=b(ie);e==1?N(L,ce,H):N(L,G,he),N(L,ce,he),H=he,G=ce}let U=G;s&&e==1&&(U=P+E,N(L,U,H));let[se,X]=od(r,o);if(l.fill!=null||se!=0){let Y=R.fill=new Path2D(L),ie=l.fillTo(r,o,l.min,l.max,se),ce=b(ie);N(Y,U,ce),N(Y,k,ce)}if(!l.spanGaps){let Y=[];Y.push(...ad(u,d,a,c,z,x,n));let ie=l.width*Ut/2,ce=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;Y.forEach(Q=>{Q[0]+=ce,Q[1]+=he}),R.gaps=Y=l.gaps(r,o,a,c,Y),R.clip=Fl(Y,h.ori,g,m,y,A)}return X!=0&&(R.band=X==2?[bs(r,o,a,c,L,-1),bs(r,o,a,c,L,1)]:bs(r,o,a,c,L,X)),R})}function vm(i,e,t,n,s,r,o=Zt){if(i.length>1){let a=null;for(let c=0,l=1/0;c<i.length;c++)if(e[c]!==void 0){if(a!=null){let u=Tn(i[c]-i[a]);u<l&&(l=u,o=Tn(t(i[c],n,s,r)-t(i[a],n,s,r)))}a=c}}return o}function Bv(i){i=i||_a;let e=Dt(i.size,[.6,Zt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=At(s),o=1-e[0],a=Dt(e[1],Zt),c=Dt(e[2],1),l=Dt(i.disp,_a),u=Dt(i.each,f=>{}),{fill:d,stroke:h}=l;return(f,p,_,g)=>Er(f,p,(m,y,A,S,P,E,x,b,N,R,L)=>{let z=m.pxRound,H=t,D=n*Ut,G=a*Ut,k=c*Ut,U,se;S.ori==0?[U,se]=r(f,p):[se,U]=r(f,p);let X=S.dir*(S.ori==0?1:-1),Y=S.ori==0?kl:ld,ie=S.ori==0?u:(De,tt,ft,Ce,Pt,Ye,et)=>{u(De,tt,ft,Pt,Ce,et,Ye)},ce=Dt(f.bands,td).find(De=>De.series[0]==p),he=ce!=null?ce.dir:0,Q=m.fillTo(f,p,m.min,m.max,he),ge=z(x(Q,P,L,N)),_e,Te,xe,Ge=R,qe=z(m.width*Ut),ke=!1,it=null,ot=null,rt=null,ve=null;d!=null&&(qe==0||h!=null)&&(ke=!0,it=d.values(f,p,_,g),ot=new Map,new Set(it).forEach(De=>{De!=null&&ot.set(De,new Path2D)}),qe>0&&(rt=h.values(f,p,_,g),ve=new Map,new Set(rt).forEach(De=>{De!=null&&ve.set(De,new Path2D)})));let{x0:me,size:Fe}=l;if(me!=null&&Fe!=null){H=1,y=me.values(f,p,_,g),me.unit==2&&(y=y.map(ft=>f.posToVal(b+ft*R,S.key,!0)));let De=Fe.values(f,p,_,g);Fe.unit==2?Te=De[0]*R:Te=E(De[0],S,R,b)-E(0,S,R,b),Ge=vm(y,A,E,S,R,b,Ge),xe=Ge-Te+D}else Ge=vm(y,A,E,S,R,b,Ge),xe=Ge*o+D,Te=Ge-xe;xe<1&&(xe=0),qe>=Te/2&&(qe=0),xe<5&&(z=Rm);let We=xe>0,at=Ge-xe-(We?qe:0);Te=z(Hh(at,k,G)),_e=(H==0?Te/2:H==X?0:Te)-H*X*((H==0?D/2:0)+(We?qe/2:0));let ut={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Kt=ke?null:new Path2D,Yt=null;if(ce!=null)Yt=f.data[ce.series[1]];else{let{y0:De,y1:tt}=l;De!=null&&tt!=null&&(A=tt.values(f,p,_,g),Yt=De.values(f,p,_,g))}let zt=U*Te,O=se*Te;for(let De=X==1?_:g;De>=_&&De<=g;De+=X){let tt=A[De];if(tt==null)continue;if(Yt!=null){let q=Yt[De]??0;if(tt-q==0)continue;ge=x(q,P,L,N)}let ft=S.distr!=2||l!=null?y[De]:De,Ce=E(ft,S,R,b),Pt=x(Dt(tt,Q),P,L,N),Ye=z(Ce-_e),et=z(Jn(Pt,ge)),C=z(Oi(Pt,ge)),M=et-C;if(tt!=null){let q=tt<0?O:zt,fe=tt<0?zt:O;ke?(qe>0&&rt[De]!=null&&Y(ve.get(rt[De]),Ye,C+mi(qe/2),Te,Jn(0,M-qe),q,fe),it[De]!=null&&Y(ot.get(it[De]),Ye,C+mi(qe/2),Te,Jn(0,M-qe),q,fe)):Y(Kt,Ye,C+mi(qe/2),Te,Jn(0,M-qe),q,fe),ie(f,p,De,Ye-qe/2,C,Te+qe,M)}}return qe>0?ut.stroke=ke?ve:Kt:ke||(ut._fill=m.width==0?m._fill:m._stroke??m._fill,ut.width=0),ut.fill=ke?ot:Kt,ut})}function kv(i,e){let t=Dt(e?.alignGaps,0);return(n,s,r,o)=>Er(n,s,(a,c,l,u,d,h,f,p,_,g,m)=>{[r,o]=Ll(l,r,o);let y=a.pxRound,A=U=>y(h(U,u,g,p)),S=U=>y(f(U,d,m,_)),P,E,x;u.ori==0?(P=Ol,x=co,E=tg):(P=Bl,x=uo,E=ng);let b=u.dir*(u.ori==0?1:-1),N=A(c[b==1?r:o]),R=N,L=[],z=[];for(let U=b==1?r:o;U>=r&&U<=o;U+=b)if(l[U]!=null){let X=c[U],Y=A(X);L.push(R=Y),z.push(S(l[U]))}let H={stroke:i(L,z,P,x,E,y),fill:null,clip:null,band:null,gaps:null,flags:ao},D=H.stroke,[G,k]=od(n,s);if(a.fill!=null||G!=0){let U=H.fill=new Path2D(D),se=a.fillTo(n,s,a.min,a.max,G),X=S(se);x(U,R,X),x(U,N,X)}if(!a.spanGaps){let U=[];U.push(...ad(c,l,r,o,b,A,t)),H.gaps=U=a.gaps(n,s,r,o,U),H.clip=Fl(U,u.ori,p,_,g,m)}return k!=0&&(H.band=k==2?[bs(n,s,r,o,D,-1),bs(n,s,r,o,D,1)]:bs(n,s,r,o,D,k)),H})}function zv(i){return kv(Gv,i)}function Gv(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let c=Array(o),l=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],d[h]=i[h+1]-i[h],l[h]=u[h]/d[h];c[0]=l[0];for(let h=1;h<o-1;h++)l[h]===0||l[h-1]===0||l[h-1]>0!=l[h]>0?c[h]=0:(c[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/l[h-1]+(d[h]+2*d[h-1])/l[h]),isFinite(c[h])||(c[h]=0));c[o-1]=l[o-2];for(let h=0;h<o-1;h++)s(a,i[h]+d[h]/3,e[h]+c[h]*d[h]/3,i[h+1]-d[h]/3,e[h+1]-c[h+1]*d[h]/3,i[h+1],e[h+1])}return a}var Yh=new Set;function ym(){for(let i of Yh)i.syncRect(!0)}lo&&(wr(b_,io,ym),wr(M_,io,ym,!0),wr(Cl,io,()=>{Un.pxRatio=Ut}));var Vv=rg(),Hv=ig();function bm(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>$h(r,o,e,t))}function Wv(i,e){return i.map((t,n)=>n==0?{}:bn({},e,t))}function $h(i,e,t,n){return bn({},e==0?t:n,i)}function og(i,e,t){return e==null?ro:[e,t]}var Xv=og;function qv(i,e,t){return e==null?ro:Pl(e,t,Qh,!0)}function ag(i,e,t,n){return e==null?ro:Dl(e,t,i.scales[n].log,!1)}var Yv=ag;function lg(i,e,t,n){return e==null?ro:jh(e,t,i.scales[n].log,!1)}var $v=lg;function Zv(i,e,t,n,s){let r=Jn(Qp(i),Qp(e)),o=e-i,a=Fi(s/n*o,t);do{let c=t[a],l=n*c/o;if(l>=s&&r+(c<5?$s.get(c):0)<=17)return[c,l]}while(++a<t.length);return[0,0]}function Mm(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=wn((t=+s)*Ut))+"px"),[i,e,t]}function Jv(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Jt(e[2]*Ut,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Un(i,e,t){let n={mode:Dt(i.mode,1)},s=n.mode;function r(v,w,I,F){let W=w.valToPct(v);return F+I*(w.dir==-1?1-W:W)}function o(v,w,I,F){let W=w.valToPct(v);return F+I*(w.dir==-1?W:1-W)}function a(v,w,I,F){return w.ori==0?r(v,w,I,F):o(v,w,I,F)}n.valToPosH=r,n.valToPosV=o;let c=!1;n.status=0;let l=n.root=Ei(i_);if(i.id!=null&&(l.id=i.id),pi(l,i.class),i.title){let v=Ei(o_,l);v.textContent=i.title}let u=Ui("canvas"),d=n.ctx=u.getContext("2d"),h=Ei(a_,l);wr("click",h,v=>{v.target===p&&(Qt!=Hr||on!=Wr)&&kn.click(n,v)},!0);let f=n.under=Ei(l_,h);h.appendChild(u);let p=n.over=Ei(c_,h);i=oo(i);let _=+Dt(i.pxAlign,1),g=_m(_);(i.plugins||[]).forEach(v=>{v.opts&&(i=v.opts(n,i)||i)});let m=i.ms||.001,y=n.series=s==1?bm(i.series||[],hm,gm,!1):Wv(i.series||[null],mm),A=n.axes=bm(i.axes||[],um,fm,!0),S=n.scales={},P=n.bands=i.bands||[];P.forEach(v=>{v.fill=At(v.fill||null),v.dir=Dt(v.dir,-1)});let E=s==2?y[1].facets[0].scale:y[0].scale,x={axes:fs,series:Mt},b=(i.drawOrder||["axes","series"]).map(v=>x[v]);function N(v){let w=v.distr==3?I=>ys(I>0?I:v.clamp(n,I,v.min,v.max,v.key)):v.distr==4?I=>Uh(I,v.asinh):v.distr==100?I=>v.fwd(I):I=>I;return I=>{let F=w(I),{_min:W,_max:j}=v,ue=j-W;return(F-W)/ue}}function R(v){let w=S[v];if(w==null){let I=(i.scales||_a)[v]||_a;if(I.from!=null){R(I.from);let F=bn({},S[I.from],I,{key:v});F.valToPct=N(F),S[v]=F}else{w=S[v]=bn({},v==E?Jm:Lv,I),w.key=v;let F=w.time,W=w.range,j=Ys(W);if((v!=E||s==2&&!F)&&(j&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Jp:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Jp:{mode:1,hard:W[1],soft:W[1]}},j=!1),!j&&Ul(W))){let ue=W;W=(be,Re,ze)=>Re==null?ro:Pl(Re,ze,ue)}w.range=At(W||(F?Xv:v==E?w.distr==3?Yv:w.distr==4?$v:og:w.distr==3?ag:w.distr==4?lg:qv)),w.auto=At(j?!1:w.auto),w.clamp=At(w.clamp||Iv),w._min=w._max=null,w.valToPct=N(w)}}}R("x"),R("y"),s==1&&y.forEach(v=>{R(v.scale)}),A.forEach(v=>{R(v.scale)});for(let v in i.scales)R(v);let L=S[E],z=L.distr,H,D;L.ori==0?(pi(l,s_),H=r,D=o):(pi(l,r_),H=o,D=r);let G={};for(let v in S){let w=S[v];(w.min!=null||w.max!=null)&&(G[v]={min:w.min,max:w.max},w.min=w.max=null)}let k=i.tzDate||(v=>new Date(wn(v/m))),U=i.fmtDate||nd,se=m==1?sv(k):av(k),X=am(k,om(m==1?iv:ov,U)),Y=cm(k,lm(cv,U)),ie=[],ce=n.legend=bn({},dv,i.legend),he=n.cursor=bn({},_v,{drag:{y:s==2}},i.cursor),Q=ce.show,ge=he.show,_e=ce.markers;ce.idxs=ie,_e.width=At(_e.width),_e.dash=At(_e.dash),_e.stroke=At(_e.stroke),_e.fill=At(_e.fill);let Te,xe,Ge,qe=[],ke=[],it,ot=!1,rt={};if(ce.live){let v=y[1]?y[1].values:null;ot=v!=null,it=ot?v(n,1,0):{_:0};for(let w in it)rt[w]=Jh}if(Q)if(Te=Ui("table",m_,l),Ge=Ui("tbody",null,Te),ce.mount(n,Te),ot){xe=Ui("thead",null,Te,Ge);let v=Ui("tr",null,xe);Ui("th",null,v);for(var ve in it)Ui("th",Op,v).textContent=ve}else pi(Te,x_),ce.live&&pi(Te,g_);let me={show:!0},Fe={show:!1};function We(v,w){if(w==0&&(ot||!ce.live||s==2))return ro;let I=[],F=Ui("tr",__,Ge,Ge.childNodes[w]);pi(F,v.class),v.show||pi(F,Sr);let W=Ui("th",null,F);if(_e.show){let be=Ei(v_,W);if(w>0){let Re=_e.width(n,w);Re&&(be.style.border=Re+"px "+_e.dash(n,w)+" "+_e.stroke(n,w)),be.style.background=_e.fill(n,w)}}let j=Ei(Op,W);v.label instanceof HTMLElement?j.appendChild(v.label):j.textContent=v.label,w>0&&(_e.show||(j.style.color=v.width>0?_e.stroke(n,w):_e.fill(n,w)),ut("click",W,be=>{if(he._lock)return;st(be);let Re=y.indexOf(v);if((be.ctrlKey||be.metaKey)!=ce.isolate){let ze=y.some((Ve,$e)=>$e>0&&$e!=Re&&Ve.show);y.forEach((Ve,$e)=>{$e>0&&Ji($e,ze?$e==Re?me:Fe:me,!0,vn.setSeries)})}else Ji(Re,{show:!v.show},!0,vn.setSeries)},!1),nt&&ut(Gp,W,be=>{he._lock||(st(be),Ji(y.indexOf(v),qr,!0,vn.setSeries))},!1));for(var ue in it){let be=Ui("td",y_,F);be.textContent="--",I.push(be)}return[F,I]}let at=new Map;function ut(v,w,I,F=!0){let W=at.get(w)||{},j=he.bind[v](n,w,I,F);j&&(wr(v,w,W[v]=j),at.set(w,W))}function Kt(v,w,I){let F=at.get(w)||{};for(let W in F)(v==null||W==v)&&(Vh(W,w,F[W]),delete F[W]);v==null&&at.delete(w)}let Yt=0,zt=0,O=0,De=0,tt=0,ft=0,Ce=tt,Pt=ft,Ye=O,et=De,C=0,M=0,q=0,fe=0;n.bbox={};let le=!1,Se=!1,we=!1,te=!1,oe=!1,ye=!1;function B(v,w,I){(I||v!=n.width||w!=n.height)&&ae(v,w),_t(!1),we=!0,Se=!0,Gn()}function ae(v,w){n.width=Yt=O=v,n.height=zt=De=w,tt=ft=0,Ee(),je();let I=n.bbox;C=I.left=br(tt*Ut,.5),M=I.top=br(ft*Ut,.5),q=I.width=br(O*Ut,.5),fe=I.height=br(De*Ut,.5)}let re=3;function Ae(){let v=!1,w=0;for(;!v;){w++;let I=zr(w),F=Zi(w);v=w==re||I&&F,v||(ae(n.width,n.height),Se=!0)}}function Me({width:v,height:w}){B(v,w)}n.setSize=Me;function Ee(){let v=!1,w=!1,I=!1,F=!1;A.forEach((W,j)=>{if(W.show&&W._show){let{side:ue,_size:be}=W,Re=ue%2,ze=W.label!=null?W.labelSize:0,Ve=be+ze;Ve>0&&(Re?(O-=Ve,ue==3?(tt+=Ve,F=!0):I=!0):(De-=Ve,ue==0?(ft+=Ve,v=!0):w=!0))}}),gt[0]=v,gt[1]=I,gt[2]=w,gt[3]=F,O-=Ot[1]+Ot[3],tt+=Ot[3],De-=Ot[2]+Ot[0],ft+=Ot[0]}function je(){let v=tt+O,w=ft+De,I=tt,F=ft;function W(j,ue){switch(j){case 1:return v+=ue,v-ue;case 2:return w+=ue,w-ue;case 3:return I-=ue,I+ue;case 0:return F-=ue,F+ue}}A.forEach((j,ue)=>{if(j.show&&j._show){let be=j.side;j._pos=W(be,j._size),j.label!=null&&(j._lpos=W(be,j.labelSize))}})}if(he.dataIdx==null){let v=he.hover,w=v.skip=new Set(v.skip??[]);w.add(void 0);let I=v.prox=At(v.prox),F=v.bias??=0;he.dataIdx=(W,j,ue,be)=>{if(j==0)return ue;let Re=ue,ze=I(W,j,ue,be)??Zt,Ve=ze>=0&&ze<Zt,$e=L.ori==0?O:De,xt=he.left,Nt=e[0],Lt=e[j];if(w.has(Lt[ue])){Re=null;let wt=null,lt=null,Qe;if(F==0||F==-1)for(Qe=ue;wt==null&&Qe-- >0;)w.has(Lt[Qe])||(wt=Qe);if(F==0||F==1)for(Qe=ue;lt==null&&Qe++<Lt.length;)w.has(Lt[Qe])||(lt=Qe);if(wt!=null||lt!=null)if(Ve){let tn=wt==null?-1/0:H(Nt[wt],L,$e,0),fn=lt==null?1/0:H(Nt[lt],L,$e,0),Dn=xt-tn,qt=fn-xt;Dn<=qt?Dn<=ze&&(Re=wt):qt<=ze&&(Re=lt)}else Re=lt==null?wt:wt==null?lt:ue-wt<=lt-ue?wt:lt}else Ve&&Tn(xt-H(Nt[ue],L,$e,0))>ze&&(Re=null);return Re}}let st=v=>{he.event=v};he.idxs=ie,he._lock=!1;let de=he.points;de.show=At(de.show),de.size=At(de.size),de.stroke=At(de.stroke),de.width=At(de.width),de.fill=At(de.fill);let He=n.focus=bn({},i.focus||{alpha:.3},he.focus),nt=He.prox>=0,Pe=nt&&de.one,mt=[],Wt=[],Cn=[];function $(v,w){let I=de.show(n,w);if(I instanceof HTMLElement)return pi(I,p_),pi(I,v.class),ns(I,-10,-10,O,De),p.insertBefore(I,mt[w]),I}function pe(v,w){if(s==1||w>0){let I=s==1&&S[v.scale].time,F=v.value;v.value=I?nm(F)?cm(k,lm(F,U)):F||Y:F||Rv,v.label=v.label||(I?yv:vv)}if(Pe||w>0){v.width=v.width==null?1:v.width,v.paths=v.paths||Vv||L_,v.fillTo=At(v.fillTo||Dv),v.pxAlign=+Dt(v.pxAlign,_),v.pxRound=_m(v.pxAlign),v.stroke=At(v.stroke||null),v.fill=At(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let I=Cv(Jn(1,v.width),1),F=v.points=bn({},{size:I,width:Jn(1,I*.2),stroke:v.stroke,space:I*2,paths:Hv,_stroke:null,_fill:null},v.points);F.show=At(F.show),F.filter=At(F.filter),F.fill=At(F.fill),F.stroke=At(F.stroke),F.paths=At(F.paths),F.pxAlign=v.pxAlign}if(Q){let I=We(v,w);qe.splice(w,0,I[0]),ke.splice(w,0,I[1]),ce.values.push(null)}if(ge){ie.splice(w,0,null);let I=null;Pe?w==0&&(I=$(v,w)):w>0&&(I=$(v,w)),mt.splice(w,0,I),Wt.splice(w,0,0),Cn.splice(w,0,0)}Ln("addSeries",w)}function Ne(v,w){w=w??y.length,v=s==1?$h(v,w,hm,gm):$h(v,w,{},mm),y.splice(w,0,v),pe(y[w],w)}n.addSeries=Ne;function Ke(v){if(y.splice(v,1),Q){ce.values.splice(v,1),ke.splice(v,1);let w=qe.splice(v,1)[0];Kt(null,w.firstChild),w.remove()}ge&&(ie.splice(v,1),mt.splice(v,1)[0].remove(),Wt.splice(v,1),Cn.splice(v,1)),Ln("delSeries",v)}n.delSeries=Ke;let gt=[!1,!1,!1,!1];function Ft(v,w){if(v._show=v.show,v.show){let I=v.side%2,F=S[v.scale];F==null&&(v.scale=I?y[1].scale:E,F=S[v.scale]);let W=F.time;v.size=At(v.size),v.space=At(v.space),v.rotate=At(v.rotate),Ys(v.incrs)&&v.incrs.forEach(ue=>{!$s.has(ue)&&$s.set(ue,Im(ue))}),v.incrs=At(v.incrs||(F.distr==2?ev:W?m==1?nv:rv:Mr)),v.splits=At(v.splits||(W&&F.distr==1?se:F.distr==3?Wh:F.distr==4?Sv:Mv)),v.stroke=At(v.stroke),v.grid.stroke=At(v.grid.stroke),v.ticks.stroke=At(v.ticks.stroke),v.border.stroke=At(v.border.stroke);let j=v.values;v.values=Ys(j)&&!Ys(j[0])?At(j):W?Ys(j)?am(k,om(j,U)):nm(j)?lv(k,j):j||X:j||bv,v.filter=At(v.filter||(F.distr>=3&&F.log==10?Ev:F.distr==3&&F.log==2?Av:Cm)),v.font=Mm(v.font),v.labelFont=Mm(v.labelFont),v._size=v.size(n,null,w,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(gt[w]=!0,v._el=Ei(u_,h))}}function St(v,w,I,F){let[W,j,ue,be]=I,Re=w%2,ze=0;return Re==0&&(be||j)&&(ze=w==0&&!W||w==2&&!ue?wn(um.size/3):0),Re==1&&(W||ue)&&(ze=w==1&&!j||w==3&&!be?wn(fm.size/2):0),ze}let jt=n.padding=(i.padding||[St,St,St,St]).map(v=>At(Dt(v,St))),Ot=n._padding=jt.map((v,w)=>v(n,w,gt,0)),It,Xt=null,rn=null,$i=s==1?y[0].idxs:null,ai=null,Us=!1;function Xo(v,w){if(e=v??[],n.data=n._data=e,s==2){It=0;for(let I=1;I<y.length;I++)It+=e[I][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),ai=e[0],It=ai.length;let I=e;if(z==2){I=e.slice();let F=I[0]=Array(It);for(let W=0;W<It;W++)F[W]=W}n._data=e=I}if(_t(!0),Ln("setData"),z==2&&(we=!0),w!==!1){let I=L;I.auto(n,Us)?qo():Bs(E,I.min,I.max),te=te||he.left>=0,ye=!0,Gn()}}n.setData=Xo;function qo(){Us=!0;let v,w;s==1&&(It>0?(Xt=$i[0]=0,rn=$i[1]=It-1,v=e[0][Xt],w=e[0][rn],z==2?(v=Xt,w=rn):v==w&&(z==3?[v,w]=Dl(v,v,L.log,!1):z==4?[v,w]=jh(v,v,L.log,!1):L.time?w=v+wn(86400/m):[v,w]=Pl(v,w,Qh,!0))):(Xt=$i[0]=v=null,rn=$i[1]=w=null)),Bs(E,v,w)}let Br,Fs,kr,T,V,ne,Z,K,Ie,Ue;function Le(v,w,I,F,W,j){v??=kp,I??=td,F??="butt",W??=kp,j??="round",v!=Br&&(d.strokeStyle=Br=v),W!=Fs&&(d.fillStyle=Fs=W),w!=kr&&(d.lineWidth=kr=w),j!=V&&(d.lineJoin=V=j),F!=ne&&(d.lineCap=ne=F),I!=T&&d.setLineDash(T=I)}function Oe(v,w,I,F){w!=Fs&&(d.fillStyle=Fs=w),v!=Z&&(d.font=Z=v),I!=K&&(d.textAlign=K=I),F!=Ie&&(d.textBaseline=Ie=F)}function Je(v,w,I,F,W=0){if(F.length>0&&v.auto(n,Us)&&(w==null||w.min==null)){let j=Dt(Xt,0),ue=Dt(rn,F.length-1),be=I.min==null?E_(F,j,ue,W,v.distr==3):[I.min,I.max];v.min=Oi(v.min,I.min=be[0]),v.max=Jn(v.max,I.max=be[1])}}let ht={min:null,max:null};function bt(){for(let F in S){let W=S[F];G[F]==null&&(W.min==null||G[E]!=null&&W.auto(n,Us))&&(G[F]=ht)}for(let F in S){let W=S[F];G[F]==null&&W.from!=null&&G[W.from]!=null&&(G[F]=ht)}G[E]!=null&&_t(!0);let v={};for(let F in G){let W=G[F];if(W!=null){let j=v[F]=oo(S[F],U_);if(W.min!=null)bn(j,W);else if(F!=E||s==2)if(It==0&&j.from==null){let ue=j.range(n,null,null,F);j.min=ue[0],j.max=ue[1]}else j.min=Zt,j.max=-Zt}}if(It>0){y.forEach((F,W)=>{if(s==1){let j=F.scale,ue=G[j];if(ue==null)return;let be=v[j];if(W==0){let Re=be.range(n,be.min,be.max,j);be.min=Re[0],be.max=Re[1],Xt=Fi(be.min,e[0]),rn=Fi(be.max,e[0]),rn-Xt>1&&(e[0][Xt]<be.min&&Xt++,e[0][rn]>be.max&&rn--),F.min=ai[Xt],F.max=ai[rn]}else F.show&&F.auto&&Je(be,ue,F,e[W],F.sorted);F.idxs[0]=Xt,F.idxs[1]=rn}else if(W>0&&F.show&&F.auto){let[j,ue]=F.facets,be=j.scale,Re=ue.scale,[ze,Ve]=e[W],$e=v[be],xt=v[Re];$e!=null&&Je($e,G[be],j,ze,j.sorted),xt!=null&&Je(xt,G[Re],ue,Ve,ue.sorted),F.min=ue.min,F.max=ue.max}});for(let F in v){let W=v[F],j=G[F];if(W.from==null&&(j==null||j.min==null)){let ue=W.range(n,W.min==Zt?null:W.min,W.max==-Zt?null:W.max,F);W.min=ue[0],W.max=ue[1]}}}for(let F in v){let W=v[F];if(W.from!=null){let j=v[W.from];if(j.min==null)W.min=W.max=null;else{let ue=W.range(n,j.min,j.max,F);W.min=ue[0],W.max=ue[1]}}}let w={},I=!1;for(let F in v){let W=v[F],j=S[F];if(j.min!=W.min||j.max!=W.max){j.min=W.min,j.max=W.max;let ue=j.distr;j._min=ue==3?ys(j.min):ue==4?Uh(j.min,j.asinh):ue==100?j.fwd(j.min):j.min,j._max=ue==3?ys(j.max):ue==4?Uh(j.max,j.asinh):ue==100?j.fwd(j.max):j.max,w[F]=I=!0}}if(I){y.forEach((F,W)=>{s==2?W>0&&w.y&&(F._paths=null):w[F.scale]&&(F._paths=null)});for(let F in w)we=!0,Ln("setScale",F);ge&&he.left>=0&&(te=ye=!0)}for(let F in G)G[F]=null}function Ze(v){let w=Hh(Xt-1,0,It-1),I=Hh(rn+1,0,It-1);for(;v[w]==null&&w>0;)w--;for(;v[I]==null&&I<It-1;)I++;return[w,I]}function Mt(){if(It>0){let v=y.some(w=>w._focus)&&Ue!=He.alpha;v&&(d.globalAlpha=Ue=He.alpha),y.forEach((w,I)=>{if(I>0&&w.show&&(hn(I,!1),hn(I,!0),w._paths==null)){let F=Ue;Ue!=w.alpha&&(d.globalAlpha=Ue=w.alpha);let W=s==2?[0,e[I][0].length-1]:Ze(e[I]);w._paths=w.paths(n,I,W[0],W[1]),Ue!=F&&(d.globalAlpha=Ue=F)}}),y.forEach((w,I)=>{if(I>0&&w.show){let F=Ue;Ue!=w.alpha&&(d.globalAlpha=Ue=w.alpha),w._paths!=null&&Gt(I,!1);{let W=w._paths!=null?w._paths.gaps:null,j=w.points.show(n,I,Xt,rn,W),ue=w.points.filter(n,I,j,W);(j||ue)&&(w.points._paths=w.points.paths(n,I,Xt,rn,ue),Gt(I,!0))}Ue!=F&&(d.globalAlpha=Ue=F),Ln("drawSeries",I)}}),v&&(d.globalAlpha=Ue=1)}}function hn(v,w){let I=w?y[v].points:y[v];I._stroke=I.stroke(n,v),I._fill=I.fill(n,v)}function Gt(v,w){let I=w?y[v].points:y[v],{stroke:F,fill:W,clip:j,flags:ue,_stroke:be=I._stroke,_fill:Re=I._fill,_width:ze=I.width}=I._paths;ze=Jt(ze*Ut,3);let Ve=null,$e=ze%2/2;w&&Re==null&&(Re=ze>0?"#fff":be);let xt=I.pxAlign==1&&$e>0;if(xt&&d.translate($e,$e),!w){let Nt=C-ze/2,Lt=M-ze/2,wt=q+ze,lt=fe+ze;Ve=new Path2D,Ve.rect(Nt,Lt,wt,lt)}w?Xe(be,ze,I.dash,I.cap,Re,F,W,ue,j):Vt(v,be,ze,I.dash,I.cap,Re,F,W,ue,Ve,j),xt&&d.translate(-$e,-$e)}function Vt(v,w,I,F,W,j,ue,be,Re,ze,Ve){let $e=!1;Re!=0&&P.forEach((xt,Nt)=>{if(xt.series[0]==v){let Lt=y[xt.series[1]],wt=e[xt.series[1]],lt=(Lt._paths||_a).band;Ys(lt)&&(lt=xt.dir==1?lt[0]:lt[1]);let Qe,tn=null;Lt.show&&lt&&R_(wt,Xt,rn)?(tn=xt.fill(n,Nt)||j,Qe=Lt._paths.clip):lt=null,Xe(w,I,F,W,tn,ue,be,Re,ze,Ve,Qe,lt),$e=!0}}),$e||Xe(w,I,F,W,j,ue,be,Re,ze,Ve)}let Sn=ao|qh;function Xe(v,w,I,F,W,j,ue,be,Re,ze,Ve,$e){Le(v,w,I,F,W),(Re||ze||$e)&&(d.save(),Re&&d.clip(Re),ze&&d.clip(ze)),$e?(be&Sn)==Sn?(d.clip($e),Ve&&d.clip(Ve),Et(W,ue),gn(v,j,w)):be&qh?(Et(W,ue),d.clip($e),gn(v,j,w)):be&ao&&(d.save(),d.clip($e),Ve&&d.clip(Ve),Et(W,ue),d.restore(),gn(v,j,w)):(Et(W,ue),gn(v,j,w)),(Re||ze||$e)&&d.restore()}function gn(v,w,I){I>0&&(w instanceof Map?w.forEach((F,W)=>{d.strokeStyle=Br=W,d.stroke(F)}):w!=null&&v&&d.stroke(w))}function Et(v,w){w instanceof Map?w.forEach((I,F)=>{d.fillStyle=Fs=F,d.fill(I)}):w!=null&&v&&d.fill(w)}function ds(v,w,I,F){let W=A[v],j;if(F<=0)j=[0,0];else{let ue=W._space=W.space(n,v,w,I,F),be=W._incrs=W.incrs(n,v,w,I,F,ue);j=Zv(w,I,be,F,ue)}return W._found=j}function xn(v,w,I,F,W,j,ue,be,Re,ze){let Ve=ue%2/2;_==1&&d.translate(Ve,Ve),Le(be,ue,Re,ze,be),d.beginPath();let $e,xt,Nt,Lt,wt=W+(F==0||F==3?-j:j);I==0?(xt=W,Lt=wt):($e=W,Nt=wt);for(let lt=0;lt<v.length;lt++)w[lt]!=null&&(I==0?$e=Nt=v[lt]:xt=Lt=v[lt],d.moveTo($e,xt),d.lineTo(Nt,Lt));d.stroke(),_==1&&d.translate(-Ve,-Ve)}function zr(v){let w=!0;return A.forEach((I,F)=>{if(!I.show)return;let W=S[I.scale];if(W.min==null){I._show&&(w=!1,I._show=!1,_t(!1));return}else I._show||(w=!1,I._show=!0,_t(!1));let j=I.side,ue=j%2,{min:be,max:Re}=W,[ze,Ve]=ds(F,be,Re,ue==0?O:De);if(Ve==0)return;let $e=W.distr==2,xt=I._splits=I.splits(n,F,be,Re,ze,Ve,$e),Nt=W.distr==2?xt.map(Qe=>ai[Qe]):xt,Lt=W.distr==2?ai[xt[1]]-ai[xt[0]]:ze,wt=I._values=I.values(n,I.filter(n,Nt,F,Ve,Lt),F,Ve,Lt);I._rotate=j==2?I.rotate(n,wt,F,Ve):0;let lt=I._size;I._size=Ai(I.size(n,wt,F,v)),lt!=null&&I._size!=lt&&(w=!1)}),w}function Zi(v){let w=!0;return jt.forEach((I,F)=>{let W=I(n,F,gt,v);W!=Ot[F]&&(w=!1),Ot[F]=W}),w}function fs(){for(let v=0;v<A.length;v++){let w=A[v];if(!w.show||!w._show)continue;let I=w.side,F=I%2,W,j,ue=w.stroke(n,v),be=I==0||I==3?-1:1,[Re,ze]=w._found;if(w.label!=null){let $n=w.labelGap*be,ui=wn((w._lpos+$n)*Ut);Oe(w.labelFont[0],ue,"center",I==2?"top":Bp),d.save(),F==1?(W=j=0,d.translate(ui,wn(M+fe/2)),d.rotate((I==3?-Rl:Rl)/2)):(W=wn(C+q/2),j=ui);let pr=Am(w.label)?w.label(n,v,Re,ze):w.label;d.fillText(pr,W,j),d.restore()}if(ze==0)continue;let Ve=S[w.scale],$e=F==0?q:fe,xt=F==0?C:M,Nt=w._splits,Lt=Ve.distr==2?Nt.map($n=>ai[$n]):Nt,wt=Ve.distr==2?ai[Nt[1]]-ai[Nt[0]]:Re,lt=w.ticks,Qe=w.border,tn=lt.show?lt.size:0,fn=wn(tn*Ut),Dn=wn((w.alignTo==2?w._size-tn-w.gap:w.gap)*Ut),qt=w._rotate*-Rl/180,pn=g(w._pos*Ut),li=(fn+Dn)*be,Yn=pn+li;j=F==0?Yn:0,W=F==1?Yn:0;let Si=w.font[0],Li=w.align==1?to:w.align==2?Lh:qt>0?to:qt<0?Lh:F==0?"center":I==3?Lh:to,ji=qt||F==1?"middle":I==2?"top":Bp;Oe(Si,ue,Li,ji);let ci=w.font[1]*w.lineGap,wi=Nt.map($n=>g(a($n,Ve,$e,xt))),Di=w._values;for(let $n=0;$n<Di.length;$n++){let ui=Di[$n];if(ui!=null){F==0?W=wi[$n]:j=wi[$n],ui=""+ui;let pr=ui.indexOf(`
`)==-1?[ui]:ui.split(/\n/gm);for(let Zn=0;Zn<pr.length;Zn++){let np=pr[Zn];qt?(d.save(),d.translate(W,j+Zn*ci),d.rotate(qt),d.fillText(np,0,0),d.restore()):d.fillText(np,W,j+Zn*ci)}}}lt.show&&xn(wi,lt.filter(n,Lt,v,ze,wt),F,I,pn,fn,Jt(lt.width*Ut,3),lt.stroke(n,v),lt.dash,lt.cap);let Qi=w.grid;Qi.show&&xn(wi,Qi.filter(n,Lt,v,ze,wt),F,F==0?2:1,F==0?M:C,F==0?fe:q,Jt(Qi.width*Ut,3),Qi.stroke(n,v),Qi.dash,Qi.cap),Qe.show&&xn([pn],[1],F==0?1:0,F==0?1:2,F==1?M:C,F==1?fe:q,Jt(Qe.width*Ut,3),Qe.stroke(n,v),Qe.dash,Qe.cap)}Ln("drawAxes")}function _t(v){y.forEach((w,I)=>{I>0&&(w._paths=null,v&&(s==1?(w.min=null,w.max=null):w.facets.forEach(F=>{F.min=null,F.max=null})))})}let dn=!1,qn=!1,Ht=[];function _n(){qn=!1;for(let v=0;v<Ht.length;v++)Ln(...Ht[v]);Ht.length=0}function Gn(){dn||(V_(Bf),dn=!0)}function hl(v,w=!1){dn=!0,qn=w,v(n),Bf(),w&&Ht.length>0&&queueMicrotask(_n)}n.batch=hl;function Bf(){if(le&&(bt(),le=!1),we&&(Ae(),we=!1),Se){if(nn(f,to,tt),nn(f,"top",ft),nn(f,pa,O),nn(f,ma,De),nn(p,to,tt),nn(p,"top",ft),nn(p,pa,O),nn(p,ma,De),nn(h,pa,Yt),nn(h,ma,zt),u.width=wn(Yt*Ut),u.height=wn(zt*Ut),A.forEach(({_el:v,_show:w,_size:I,_pos:F,side:W})=>{if(v!=null)if(w){let j=W===3||W===0?I:0,ue=W%2==1;nn(v,ue?"left":"top",F-j),nn(v,ue?"width":"height",I),nn(v,ue?"top":"left",ue?ft:tt),nn(v,ue?"height":"width",ue?De:O),Gh(v,Sr)}else pi(v,Sr)}),Br=Fs=kr=V=ne=Z=K=Ie=T=null,Ue=1,Zo(!0),tt!=Ce||ft!=Pt||O!=Ye||De!=et){_t(!1);let v=O/Ye,w=De/et;if(ge&&!te&&he.left>=0){he.left*=v,he.top*=w,Gr&&ns(Gr,wn(he.left),0,O,De),Vr&&ns(Vr,0,wn(he.top),O,De);for(let I=0;I<mt.length;I++){let F=mt[I];F!=null&&(Wt[I]*=v,Cn[I]*=w,ns(F,Ai(Wt[I]),Ai(Cn[I]),O,De))}}if(en.show&&!oe&&en.left>=0&&en.width>0){en.left*=v,en.width*=v,en.top*=w,en.height*=w;for(let I in Xu)nn(Xr,I,en[I])}Ce=tt,Pt=ft,Ye=O,et=De}Ln("setSize"),Se=!1}Yt>0&&zt>0&&(d.clearRect(0,0,u.width,u.height),Ln("drawClear"),b.forEach(v=>v()),Ln("draw")),en.show&&oe&&(dl(en),oe=!1),ge&&te&&(fr(null,!0,!1),te=!1),ce.show&&ce.live&&ye&&(Hu(),ye=!1),c||(c=!0,n.status=1,Ln("ready")),Us=!1,dn=!1}n.redraw=(v,w)=>{we=w||!1,v!==!1?Bs(E,L.min,L.max):Gn()};function zu(v,w){let I=S[v];if(I.from==null){if(It==0){let F=I.range(n,w.min,w.max,v);w.min=F[0],w.max=F[1]}if(w.min>w.max){let F=w.min;w.min=w.max,w.max=F}if(It>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;v==E&&I.distr==2&&It>0&&(w.min=Fi(w.min,e[0]),w.max=Fi(w.max,e[0]),w.min==w.max&&w.max++),G[v]=w,le=!0,Gn()}}n.setScale=zu;let Gu,Vu,Gr,Vr,kf,zf,Hr,Wr,Gf,Vf,Qt,on,Os=!1,kn=he.drag,Pn=kn.x,In=kn.y;ge&&(he.x&&(Gu=Ei(d_,p)),he.y&&(Vu=Ei(f_,p)),L.ori==0?(Gr=Gu,Vr=Vu):(Gr=Vu,Vr=Gu),Qt=he.left,on=he.top);let en=n.select=bn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),Xr=en.show?Ei(h_,en.over?p:f):null;function dl(v,w){if(en.show){for(let I in v)en[I]=v[I],I in Xu&&nn(Xr,I,v[I]);w!==!1&&Ln("setSelect")}}n.setSelect=dl;function yx(v){if(y[v].show)Q&&Gh(qe[v],Sr);else if(Q&&pi(qe[v],Sr),ge){let I=Pe?mt[0]:mt[v];I!=null&&ns(I,-10,-10,O,De)}}function Bs(v,w,I){zu(v,{min:w,max:I})}function Ji(v,w,I,F){w.focus!=null&&Tx(v),w.show!=null&&y.forEach((W,j)=>{j>0&&(v==j||v==null)&&(W.show=w.show,yx(j),s==2?(Bs(W.facets[0].scale,null,null),Bs(W.facets[1].scale,null,null)):Bs(W.scale,null,null),Gn())}),I!==!1&&Ln("setSeries",v,w),F&&Jo("setSeries",n,v,w)}n.setSeries=Ji;function bx(v,w){bn(P[v],w)}function Mx(v,w){v.fill=At(v.fill||null),v.dir=Dt(v.dir,-1),w=w??P.length,P.splice(w,0,v)}function Sx(v){v==null?P.length=0:P.splice(v,1)}n.addBand=Mx,n.setBand=bx,n.delBand=Sx;function wx(v,w){y[v].alpha=w,ge&&mt[v]!=null&&(mt[v].style.opacity=w),Q&&qe[v]&&(qe[v].style.opacity=w)}let ps,ks,dr,qr={focus:!0};function Tx(v){if(v!=dr){let w=v==null,I=He.alpha!=1;y.forEach((F,W)=>{if(s==1||W>0){let j=w||W==0||W==v;F._focus=w?null:j,I&&wx(W,j?1:He.alpha)}}),dr=v,I&&Gn()}}Q&&nt&&ut(Vp,Te,v=>{he._lock||(st(v),dr!=null&&Ji(null,qr,!0,vn.setSeries))});function Ki(v,w,I){let F=S[w];I&&(v=v/Ut-(F.ori==1?ft:tt));let W=O;F.ori==1&&(W=De,v=W-v),F.dir==-1&&(v=W-v);let j=F._min,ue=F._max,be=v/W,Re=j+(ue-j)*be,ze=F.distr;return ze==3?so(10,Re):ze==4?P_(Re,F.asinh):ze==100?F.bwd(Re):Re}function Ex(v,w){let I=Ki(v,E,w);return Fi(I,e[0],Xt,rn)}n.valToIdx=v=>Fi(v,e[0]),n.posToIdx=Ex,n.posToVal=Ki,n.valToPos=(v,w,I)=>S[w].ori==0?r(v,S[w],I?q:O,I?C:0):o(v,S[w],I?fe:De,I?M:0),n.setCursor=(v,w,I)=>{Qt=v.left,on=v.top,fr(null,w,I)};function Hf(v,w){nn(Xr,to,en.left=v),nn(Xr,pa,en.width=w)}function Wf(v,w){nn(Xr,"top",en.top=v),nn(Xr,ma,en.height=w)}let Yo=L.ori==0?Hf:Wf,$o=L.ori==1?Hf:Wf;function Ax(){if(Q&&ce.live)for(let v=s==2?1:0;v<y.length;v++){if(v==0&&ot)continue;let w=ce.values[v],I=0;for(let F in w)ke[v][I++].firstChild.nodeValue=w[F]}}function Hu(v,w){if(v!=null&&(v.idxs?v.idxs.forEach((I,F)=>{ie[F]=I}):N_(v.idx)||ie.fill(v.idx),ce.idx=ie[0]),Q&&ce.live){for(let I=0;I<y.length;I++)(I>0||s==1&&!ot)&&Rx(I,ie[I]);Ax()}ye=!1,w!==!1&&Ln("setLegend")}n.setLegend=Hu;function Rx(v,w){let I=y[v],F=v==0&&z==2?ai:e[v],W;ot?W=I.values(n,v,w)??rt:(W=I.value(n,w==null?null:F[w],v,w),W=W==null?rt:{_:W}),ce.values[v]=W}function fr(v,w,I){Gf=Qt,Vf=on,[Qt,on]=he.move(n,Qt,on),he.left=Qt,he.top=on,ge&&(Gr&&ns(Gr,wn(Qt),0,O,De),Vr&&ns(Vr,0,wn(on),O,De));let F,W=Xt>rn;ps=Zt,ks=null;let j=L.ori==0?O:De,ue=L.ori==1?O:De;if(Qt<0||It==0||W){F=he.idx=null;for(let be=0;be<y.length;be++){let Re=mt[be];Re!=null&&ns(Re,-10,-10,O,De)}nt&&Ji(null,qr,!0,v==null&&vn.setSeries),ce.live&&(ie.fill(F),ye=!0)}else{let be,Re,ze;s==1&&(be=L.ori==0?Qt:on,Re=Ki(be,E),F=he.idx=Fi(Re,e[0],Xt,rn),ze=H(e[0][F],L,j,0));let Ve=-10,$e=-10,xt=0,Nt=0,Lt=!0,wt="",lt="";for(let Qe=s==2?1:0;Qe<y.length;Qe++){let tn=y[Qe],fn=ie[Qe],Dn=fn==null?null:s==1?e[Qe][fn]:e[Qe][1][fn],qt=he.dataIdx(n,Qe,F,Re),pn=qt==null?null:s==1?e[Qe][qt]:e[Qe][1][qt];if(ye=ye||pn!=Dn||qt!=fn,ie[Qe]=qt,Qe>0&&tn.show){let li=qt==null?-10:qt==F?ze:H(s==1?e[0][qt]:e[Qe][0][qt],L,j,0),Yn=pn==null?-10:D(pn,s==1?S[tn.scale]:S[tn.facets[1].scale],ue,0);if(nt&&pn!=null){let Si=L.ori==1?Qt:on,Li=Tn(He.dist(n,Qe,qt,Yn,Si));if(Li<ps){let ji=He.bias;if(ji!=0){let ci=Ki(Si,tn.scale),wi=pn>=0?1:-1,Di=ci>=0?1:-1;Di==wi&&(Di==1?ji==1?pn>=ci:pn<=ci:ji==1?pn<=ci:pn>=ci)&&(ps=Li,ks=Qe)}else ps=Li,ks=Qe}}if(ye||Pe){let Si,Li;L.ori==0?(Si=li,Li=Yn):(Si=Yn,Li=li);let ji,ci,wi,Di,Qi,$n,ui=!0,pr=de.bbox;if(pr!=null){ui=!1;let Zn=pr(n,Qe);wi=Zn.left,Di=Zn.top,ji=Zn.width,ci=Zn.height}else wi=Si,Di=Li,ji=ci=de.size(n,Qe);if($n=de.fill(n,Qe),Qi=de.stroke(n,Qe),Pe)Qe==ks&&ps<=He.prox&&(Ve=wi,$e=Di,xt=ji,Nt=ci,Lt=ui,wt=$n,lt=Qi);else{let Zn=mt[Qe];Zn!=null&&(Wt[Qe]=wi,Cn[Qe]=Di,Zp(Zn,ji,ci,ui),Yp(Zn,$n,Qi),ns(Zn,Ai(wi),Ai(Di),O,De))}}}}if(Pe){let Qe=He.prox,tn=dr==null?ps<=Qe:ps>Qe||ks!=dr;if(ye||tn){let fn=mt[0];fn!=null&&(Wt[0]=Ve,Cn[0]=$e,Zp(fn,xt,Nt,Lt),Yp(fn,wt,lt),ns(fn,Ai(Ve),Ai($e),O,De))}}}if(en.show&&Os)if(v!=null){let[be,Re]=vn.scales,[ze,Ve]=vn.match,[$e,xt]=v.cursor.sync.scales,Nt=v.cursor.drag;if(Pn=Nt._x,In=Nt._y,Pn||In){let{left:Lt,top:wt,width:lt,height:Qe}=v.select,tn=v.scales[$e].ori,fn=v.posToVal,Dn,qt,pn,li,Yn,Si=be!=null&&ze(be,$e),Li=Re!=null&&Ve(Re,xt);Si&&Pn?(tn==0?(Dn=Lt,qt=lt):(Dn=wt,qt=Qe),pn=S[be],li=H(fn(Dn,$e),pn,j,0),Yn=H(fn(Dn+qt,$e),pn,j,0),Yo(Oi(li,Yn),Tn(Yn-li))):Yo(0,j),Li&&In?(tn==1?(Dn=Lt,qt=lt):(Dn=wt,qt=Qe),pn=S[Re],li=D(fn(Dn,xt),pn,ue,0),Yn=D(fn(Dn+qt,xt),pn,ue,0),$o(Oi(li,Yn),Tn(Yn-li))):$o(0,ue)}else qu()}else{let be=Tn(Gf-kf),Re=Tn(Vf-zf);if(L.ori==1){let xt=be;be=Re,Re=xt}Pn=kn.x&&be>=kn.dist,In=kn.y&&Re>=kn.dist;let ze=kn.uni;ze!=null?Pn&&In&&(Pn=be>=ze,In=Re>=ze,!Pn&&!In&&(Re>be?In=!0:Pn=!0)):kn.x&&kn.y&&(Pn||In)&&(Pn=In=!0);let Ve,$e;Pn&&(L.ori==0?(Ve=Hr,$e=Qt):(Ve=Wr,$e=on),Yo(Oi(Ve,$e),Tn($e-Ve)),In||$o(0,ue)),In&&(L.ori==1?(Ve=Hr,$e=Qt):(Ve=Wr,$e=on),$o(Oi(Ve,$e),Tn($e-Ve)),Pn||Yo(0,j)),!Pn&&!In&&(Yo(0,0),$o(0,0))}if(kn._x=Pn,kn._y=In,v==null){if(I){if(tp!=null){let[be,Re]=vn.scales;vn.values[0]=be!=null?Ki(L.ori==0?Qt:on,be):null,vn.values[1]=Re!=null?Ki(L.ori==1?Qt:on,Re):null}Jo(Dh,n,Qt,on,O,De,F)}if(nt){let be=I&&vn.setSeries,Re=He.prox;dr==null?ps<=Re&&Ji(ks,qr,!0,be):ps>Re?Ji(null,qr,!0,be):ks!=dr&&Ji(ks,qr,!0,be)}}ye&&(ce.idx=F,Hu()),w!==!1&&Ln("setCursor")}let zs=null;Object.defineProperty(n,"rect",{get(){return zs==null&&Zo(!1),zs}});function Zo(v=!1){v?zs=null:(zs=p.getBoundingClientRect(),Ln("syncRect",zs))}function Xf(v,w,I,F,W,j,ue){he._lock||Os&&v!=null&&v.movementX==0&&v.movementY==0||(Wu(v,w,I,F,W,j,ue,!1,v!=null),v!=null?fr(null,!0,!0):fr(w,!0,!1))}function Wu(v,w,I,F,W,j,ue,be,Re){if(zs==null&&Zo(!1),st(v),v!=null)I=v.clientX-zs.left,F=v.clientY-zs.top;else{if(I<0||F<0){Qt=-10,on=-10;return}let[ze,Ve]=vn.scales,$e=w.cursor.sync,[xt,Nt]=$e.values,[Lt,wt]=$e.scales,[lt,Qe]=vn.match,tn=w.axes[0].side%2==1,fn=L.ori==0?O:De,Dn=L.ori==1?O:De,qt=tn?j:W,pn=tn?W:j,li=tn?F:I,Yn=tn?I:F;if(Lt!=null?I=lt(ze,Lt)?a(xt,S[ze],fn,0):-10:I=fn*(li/qt),wt!=null?F=Qe(Ve,wt)?a(Nt,S[Ve],Dn,0):-10:F=Dn*(Yn/pn),L.ori==1){let Si=I;I=F,F=Si}}Re&&(w==null||w.cursor.event.type==Dh)&&((I<=1||I>=O-1)&&(I=br(I,O)),(F<=1||F>=De-1)&&(F=br(F,De))),be?(kf=I,zf=F,[Hr,Wr]=he.move(n,I,F)):(Qt=I,on=F)}let Xu={width:0,height:0,left:0,top:0};function qu(){dl(Xu,!1)}let qf,Yf,$f,Zf;function Jf(v,w,I,F,W,j,ue){Os=!0,Pn=In=kn._x=kn._y=!1,Wu(v,w,I,F,W,j,ue,!0,!1),v!=null&&(ut(Nh,kh,Kf,!1),Jo(zp,n,Hr,Wr,O,De,null));let{left:be,top:Re,width:ze,height:Ve}=en;qf=be,Yf=Re,$f=ze,Zf=Ve}function Kf(v,w,I,F,W,j,ue){Os=kn._x=kn._y=!1,Wu(v,w,I,F,W,j,ue,!1,!0);let{left:be,top:Re,width:ze,height:Ve}=en,$e=ze>0||Ve>0,xt=qf!=be||Yf!=Re||$f!=ze||Zf!=Ve;if($e&&xt&&dl(en),kn.setScale&&$e&&xt){let Nt=be,Lt=ze,wt=Re,lt=Ve;if(L.ori==1&&(Nt=Re,Lt=Ve,wt=be,lt=ze),Pn&&Bs(E,Ki(Nt,E),Ki(Nt+Lt,E)),In)for(let Qe in S){let tn=S[Qe];Qe!=E&&tn.from==null&&tn.min!=Zt&&Bs(Qe,Ki(wt+lt,Qe),Ki(wt,Qe))}qu()}else he.lock&&(he._lock=!he._lock,fr(w,!0,v!=null));v!=null&&(Kt(Nh,kh),Jo(Nh,n,Qt,on,O,De,null))}function Cx(v,w,I,F,W,j,ue){if(he._lock)return;st(v);let be=Os;if(Os){let Re=!0,ze=!0,Ve=10,$e,xt;L.ori==0?($e=Pn,xt=In):($e=In,xt=Pn),$e&&xt&&(Re=Qt<=Ve||Qt>=O-Ve,ze=on<=Ve||on>=De-Ve),$e&&Re&&(Qt=Qt<Hr?0:O),xt&&ze&&(on=on<Wr?0:De),fr(null,!0,!0),Os=!1}Qt=-10,on=-10,ie.fill(null),fr(null,!0,!0),be&&(Os=be)}function jf(v,w,I,F,W,j,ue){he._lock||(st(v),qo(),qu(),v!=null&&Jo(Hp,n,Qt,on,O,De,null))}function Qf(){A.forEach(Jv),B(n.width,n.height,!0)}wr(Cl,io,Qf);let Yr={};Yr.mousedown=Jf,Yr.mousemove=Xf,Yr.mouseup=Kf,Yr.dblclick=jf,Yr.setSeries=(v,w,I,F)=>{let W=vn.match[2];I=W(n,w,I),I!=-1&&Ji(I,F,!0,!1)},ge&&(ut(zp,p,Jf),ut(Dh,p,Xf),ut(Gp,p,v=>{st(v),Zo(!1)}),ut(Vp,p,Cx),ut(Hp,p,jf),Yh.add(n),n.syncRect=Zo);let fl=n.hooks=i.hooks||{};function Ln(v,w,I){qn?Ht.push([v,w,I]):v in fl&&fl[v].forEach(F=>{F.call(null,n,w,I)})}(i.plugins||[]).forEach(v=>{for(let w in v.hooks)fl[w]=(fl[w]||[]).concat(v.hooks[w])});let ep=(v,w,I)=>I,vn=bn({key:null,setSeries:!1,filters:{pub:em,sub:em},scales:[E,y[1]?y[1].scale:null],match:[tm,tm,ep],values:[null,null]},he.sync);vn.match.length==2&&vn.match.push(ep),he.sync=vn;let tp=vn.key,Yu=Km(tp);function Jo(v,w,I,F,W,j,ue){vn.filters.pub(v,w,I,F,W,j,ue)&&Yu.pub(v,w,I,F,W,j,ue)}Yu.sub(n);function Px(v,w,I,F,W,j,ue){vn.filters.sub(v,w,I,F,W,j,ue)&&Yr[v](null,w,I,F,W,j,ue)}n.pub=Px;function Ix(){Yu.unsub(n),Yh.delete(n),at.clear(),Vh(Cl,io,Qf),l.remove(),Te?.remove(),Ln("destroy")}n.destroy=Ix;function $u(){Ln("init",i,e),Xo(e||i.data,!1),G[E]?zu(E,G[E]):qo(),oe=en.show&&(en.width>0||en.height>0),te=ye=!0,B(i.width,i.height)}return y.forEach(pe),A.forEach(Ft),t?t instanceof HTMLElement?(t.appendChild(l),$u()):t(n,$u):$u(),n}Un.assign=bn;Un.fmtNum=ed;Un.rangeNum=Pl;Un.rangeLog=Dl;Un.rangeAsinh=jh;Un.orient=Er;Un.pxRatio=Ut;Un.join=G_;Un.fmtDate=nd,Un.tzDate=j_;Un.sync=Km;{Un.addGap=Nv,Un.clipGaps=Fl;let i=Un.paths={points:ig};i.linear=rg,i.stepped=Ov,i.bars=Bv,i.spline=zv}var zl="#D55E00",Kv="11px system-ui, sans-serif",cg=7,jv=3.6,cd=new Map,Zs=class{constructor(e){this.options=e;let{title:t,unit:n,lines:s,duration:r,sync:o,onTime:a}=e,c=`${t} (${n})`;this.values=s.map(({colour:f,label:p,mark:_,dashed:g})=>{let m=_===void 0?J("i",{class:g?"line dashed":"line",style:`--colour:${f||"var(--ink)"}`}):ni(_,f);return J("span",{title:p,class:"value"},m,J("b"))});let l={tabindex:0,role:"slider","aria-label":c,"aria-valuemin":0,"aria-valuemax":r,"aria-valuenow":0,"aria-valuetext":""};this.place=J("div",{class:"plot",...a?l:{role:"img","aria-label":c}}),this.element=J("figure",{},J("figcaption",{},J("span",{},c),J("span",{class:"readout"},...this.values)),this.place);let u={stroke:()=>hi("soft"),font:Kv,grid:{stroke:()=>hi("grid"),width:1},ticks:{stroke:()=>hi("grid"),width:1,size:4}},d=Un.paths.stepped({align:1});this.plot=new Un({width:320,height:150,legend:{show:!1},padding:[8,18,0,0],cursor:{points:{show:!1},y:!1,drag:{x:o!==void 0,y:!1},...o&&{sync:{key:o,scales:["x",null]}}},scales:{x:{time:!1,range:(f,p,_)=>Number.isFinite(p)&&p<_?[p,_]:[0,r]},y:{range:(f,p,_)=>this.visible(p??0,_??0,e.range??e.limits)}},axes:[{...u,size:26,gap:3,values:(f,p)=>p.map(_=>_===p.at(-1)?`${_} s`:`${_}`)},{...u,size:46,gap:3,values:(f,p)=>p.map(_=>`${Number(_.toPrecision(6))}`.replace("-","\u2212"))}],series:[{},...s.map(({label:f,colour:p,dashed:_,held:g,mark:m})=>({label:f,stroke:()=>p||hi("ink"),width:_?1.25:1.6,points:{show:!1},..._?{dash:[5,4]}:m!==void 0&&{dash:rp(m)},...g&&{paths:d}}))],hooks:{drawClear:[f=>e.limits&&Qv(f,e.limits)],draw:[f=>s.forEach((p,_)=>p.mark!==void 0&&ey(f,_+1,p))],setScale:[(f,p)=>p==="x"&&this.zoomGroup(f)],setSize:[()=>this.seek(this.time)]}},[[0,r],...s.map(()=>[null,null])],this.place),this.plot.over.append(this.playhead),a&&(this.plot.over.addEventListener("click",f=>{let{left:p}=this.plot.over.getBoundingClientRect();a(this.plot.posToVal(f.clientX-p,"x"))}),this.place.addEventListener("keydown",f=>this.key(f,a))),o&&cd.set(o,[...cd.get(o)??[],this]);let h=()=>ml()||this.plot.setSize({width:this.place.clientWidth,height:this.place.clientHeight});new ResizeObserver(h).observe(this.place),Gs(()=>this.plot.redraw(!1))}options;element;place;values;playhead=J("div",{class:"playhead"});plot;time=0;get canvas(){return this.plot.ctx.canvas}show(e,t){let[{min:n,max:s}]=[this.plot.scales.x];this.plot.setData([e,...t],!1),this.plot.setScale("x",{min:n??0,max:s??this.options.duration})}setDuration(e){this.options.duration=e,this.place.setAttribute("aria-valuemax",`${e}`),this.plot.setScale("x",{min:0,max:e})}setLimits(e){this.options.limits=e}setRange(e){this.options.range=e}setVisible(e,t){this.plot.setSeries(e+1,{show:t}),this.values[e].hidden=!t}seek(e){this.time=e;let{left:t,width:n}=this.plot.bbox,s=this.plot.valToPos(e,"x");this.playhead.style.transform=`translateX(${s}px)`,this.playhead.hidden=!(s>=0&&s<=n/devicePixelRatio+1)||t===0;let[r,...o]=this.plot.data,a=0;r.length>1&&(a=Math.min(Math.max(Math.round((e-r[0])/(r[1]-r[0])),0),r.length-1)),o.forEach((c,l)=>{let u=c[a],d=u==null?"\u2013":Nn(u,this.options.digits??1),h=this.values[l].lastElementChild;h.textContent!==d&&(h.textContent=d)}),document.activeElement===this.place&&this.describe()}describe(){let e=this.values.flatMap(t=>t.hidden?[]:[`${t.title} ${t.textContent}`]);this.place.setAttribute("aria-valuenow",this.time.toFixed(2)),this.place.setAttribute("aria-valuetext",`at ${this.time.toFixed(2)} s: ${e.join(", ")} ${this.options.unit}`)}key(e,t){let n=e.shiftKey?1:.1,{min:s,max:r}=this.plot.scales.x,o=u=>{let d=.5*u*((r??1)-(s??0)),h=Math.min(Math.max(this.time,d),Math.max(this.options.duration-d,d));this.plot.setScale("x",{min:Math.max(h-d,0),max:Math.min(h+d,this.options.duration)})},a=u=>{this.time=Math.min(Math.max(u,0),this.options.duration),t(this.time)},l={ArrowLeft:()=>a(this.time-n),ArrowRight:()=>a(this.time+n),Home:()=>a(0),End:()=>a(this.options.duration),...this.options.sync&&{"+":()=>o(.5),"=":()=>o(.5),"-":()=>o(2),0:()=>o(1e3)}}[e.key];!l||e.ctrlKey||e.metaKey||e.altKey||(l(),this.describe(),e.preventDefault())}visible(e,t,n){let s=Math.min(e,n?.[0]??e),r=Math.max(t,n?.[1]??t),o=Math.max(.07*(r-s),.01);return[s-o,r+o]}zoomGroup(e){let{min:t,max:n}=e.scales.x;if(!(t==null||n==null)){for(let s of cd.get(this.options.sync??"")??[]){let r=s.plot?.scales.x;s!==this&&r&&(r.min!==t||r.max!==n)&&s.plot.setScale("x",{min:t,max:n})}this.seek(this.time)}}};function Qv(i,e){let{ctx:t,bbox:n}=i,[s,r]=e.map(o=>Math.min(Math.max(i.valToPos(o,"y",!0),n.top),n.top+n.height));t.save(),t.fillStyle=`${zl}17`,t.fillRect(n.left,n.top,n.width,r-n.top),t.fillRect(n.left,s,n.width,n.top+n.height-s),t.strokeStyle=`${zl}99`,t.lineWidth=devicePixelRatio,t.beginPath();for(let o of[s,r])t.moveTo(n.left,Math.round(o)+.5),t.lineTo(n.left+n.width,Math.round(o)+.5);t.stroke(),t.restore()}function ey(i,e,{mark:t=0,colour:n}){if(!i.series[e].show)return;let{ctx:s,bbox:r}=i,{min:o,max:a}=i.scales.x,[c,l]=[i.data[0],i.data[e]];if(o==null||a==null||c.length<2)return;let u=jv*devicePixelRatio,d=new Path2D(Ko(t));s.save(),s.beginPath(),s.rect(r.left,r.top,r.width,r.height),s.clip(),s.fillStyle=n||hi("ink");for(let h=0;h<cg;h++){let f=o+(h+.2+.13*t)/cg*(a-o),p=l[Math.round((f-c[0])/(c[1]-c[0]))];p!=null&&(s.save(),s.translate(i.valToPos(f,"x",!0),i.valToPos(p,"y",!0)),s.scale(u,u),s.fill(d),s.restore())}s.restore()}var ya=400,Js={left:44,right:10,top:10,bottom:38},ty=75,Ar=class{element;paths;tails;dots;place;points=[];constructor({title:e,axes:t,corners:n=[],outer:s=[],curve:r=[],ticks:o,colours:a,marks:c=!0}){let l=[...n,...s,...r],u=[0,1].map(m=>[Math.min(...l.map(y=>y[m])),Math.max(...l.map(y=>y[m]))]),d=u.map(([m,y])=>.08*(y-m)),h={width:ya-Js.left-Js.right,height:ya-Js.top-Js.bottom};this.place=([m,y])=>[Js.left+h.width*(m-u[0][0]+d[0])/(u[0][1]-u[0][0]+2*d[0]),Js.top+h.height-h.height*(y-u[1][0]+d[1])/(u[1][1]-u[1][0]+2*d[1])];let f=an("svg",{viewBox:`0 0 ${ya} ${ya}`,role:"img","aria-label":`${e}: ${t.join(", ")}`}),p={x:Js.left,y:Js.top,...h};f.append(an("rect",{...p,class:"frame"}));for(let m of o[0]){let[y]=this.place([m,0]);f.append(an("line",{x1:y,x2:y,y1:p.y,y2:p.y+p.height,class:"grid"}),an("text",{x:y,y:p.y+p.height+14,class:"tick"},`${m}`.replace("-","\u2212")))}for(let m of o[1]){let[,y]=this.place([0,m]);f.append(an("line",{x1:p.x,x2:p.x+p.width,y1:y,y2:y,class:"grid"}),an("text",{x:p.x-5,y:y+4,class:"tick end"},`${m}`.replace("-","\u2212")))}f.append(an("text",{x:p.x+p.width/2,y:ya-6,class:"label"},t[0]),an("text",{x:0,y:0,class:"label",transform:`translate(12 ${p.y+p.height/2}) rotate(-90)`},t[1]));let _=m=>pl(m.map(this.place));s.length&&f.append(an("polygon",{points:_(s),class:"outer"})),n.length&&f.append(an("polygon",{points:_(n),class:"set",stroke:zl})),r.length&&f.append(an("polyline",{points:_(r),class:"curve"}));let g=m=>a.map(y=>an("polyline",{class:m,stroke:y,points:""}));[this.paths,this.tails]=[g("path"),g("path tail")],this.dots=a.map((m,y)=>an("path",{d:Ko(c?y:0),fill:m,class:"dot"})),f.append(...this.paths,...this.tails,...this.dots),this.element=J("figure",{class:"set"},J("figcaption",{},J("span",{},e)),f)}show(e){this.points=e.map(t=>t.map(this.place)),this.paths.forEach((t,n)=>t.setAttribute("points",pl(this.points[n])))}setVisible(e,t){for(let n of[this.paths[e],this.tails[e],this.dots[e]])n.toggleAttribute("hidden",!t)}seek(e){this.dots.forEach((t,n)=>{let s=this.points[n]??[];if(s.length===0)return;let r=Math.min(e,s.length-1),[o,a]=s[r];this.tails[n].setAttribute("points",pl(s.slice(Math.max(0,r-ty),r+1))),t.setAttribute("transform",`translate(${o.toFixed(1)} ${a.toFixed(1)}) scale(5)`)})}};var ud=["travel","travel rate","elevation","elevation rate","pitch","pitch rate"],ug=["#0072B2","#56B4E9","#009E73","#E69F00","#CC79A7","#7A5195"],hg=([i,e])=>[[i,i],[e,i],[e,e],[i,e]];function ho(i,e){let t=(e-i)/4,n=10**Math.floor(Math.log10(t)),s=n*([1,2,5,10].find(o=>o*n>=t)??10),r=Math.ceil(i/s);return Array.from({length:Math.floor(e/s)-r+1},(o,a)=>Number(((r+a)*s).toPrecision(6)))}var Gl=class{constructor(e,t,n,s){this.policies=e;this.period=t;this.lines=n;this.onTime=s}policies;period;lines;onTime;element=J("section",{class:"paper"});figures=[];experiment=null;flights=[];turn=0;rebuild(e,t){this.experiment=e,this.figures=[];let n=this.policies.map(({colour:k})=>k),{rig:s}=e,r=eo(e.setup),o=s.parameters,a=this.period*e.steps,c=(k,U,se,...X)=>J("div",{class:"figure"},J("h3",{},k),Fp(U),J("p",{class:"small"},se),...X),l=(k,U)=>{let se=new Ar(k);return this.figures.push({refresh:()=>se.show(this.flights.map(X=>X?U(X):[])),seek:X=>se.seek(Math.floor(X/this.period)),show:(X,Y)=>se.setVisible(X,Y)}),se.element},u=(k,U,se,X,Y=1,ie)=>{let ce=new Zs({title:k,unit:U,lines:se,duration:a,digits:Y,onTime:this.onTime,...ie&&{range:ie}}),he=e.reference.x.map((Q,ge)=>ge*this.period);return this.figures.push({refresh:()=>ce.show(he,X()),seek:Q=>ce.seek(Q),show:(Q,ge)=>se===this.lines&&ce.setVisible(Q,ge)}),ce.element},d=k=>()=>this.flights.map(U=>e.reference.x.map((se,X)=>U&&X<U.x.length?k(U,X):null)),h=(k,U)=>k.u[Math.min(U,k.u.length-1)]??k.rotors,[f,p]=s.amplifier,_=ho(f,p),g=Array.from({length:61},(k,U)=>[f+(p-f)*U/60,si([f+(p-f)*U/60,0],o)[0]]),[m,y]=Jr(r.u,o),A=([k,U])=>[[0,2*k],[U-k,k+U],[0,2*U],[k-U,k+U]],S=Jr(s.amplifier,o),P=ho(2*S[0],2*S[1]),E=r.pitch[1],x=Array.from({length:61},(k,U)=>{let se=(U/30-1)*1.6*E;return[$t(se),$t(E*Math.tanh(se/E))]}),b=k=>E*Math.atanh(Math.min(Math.max(k/E,-.999),.999)),N=ho(-1.5*$t(E),1.5*$t(E)),{front:R}=o,L="cubics"in R?"f_i = f ( u_i )":`f_i = k_\xB1 ${R.dead_zone?"( | u_i | \u2212 u_0 )":"| u_i |"}^${R.exponent} sgn u_i`.replace("| u_i |^2 sgn u_i","| u_i | u_i").replace("k_\xB1 | u_i |^1 sgn u_i","k u_i"),z=this.policies.findIndex(({name:k},U)=>t[U]&&(k==="feedforward+tvlqr"||k==="yours")),H=e.gains(z<0?"feedforward+tvlqr":this.policies[z].name),D=ud.map((k,U)=>({label:k,colour:ug[U],mark:U})),G=k=>()=>ud.map((U,se)=>e.reference.x.map((X,Y)=>H[Math.min(Y,H.length-1)][k][se]));this.element.replaceChildren(J("h2",{},"The paper, drawn from this flight"),J("div",{class:"figures"},c("(2) thrust",L,"Thrust of the front fan over its voltage, and where each flight is on it.",l({title:"thrust of the front fan",axes:["front voltage (V)","thrust (N)"],curve:g,ticks:[_,ho(g[0][1],g[60][1])],colours:n},k=>k.u.map(U=>[U[0],si(U,o)[0]]))),c("(3a) travel","q\u0308_1 = b_1 cos q_2 sin q_3 v_1 \u2212 c_1 q\u0307_1","Only a pitched helicopter accelerates sideways: the travel acceleration that (3) makes of pitch and thrust.",u("travel acceleration","deg/s\xB2",this.lines,d((k,U)=>$t(zn(k.x[U],ri(h(k,U),o),o)[1])),1,[-1,1])),c("(6), (9) voltages","u_min \u2264 u_f , u_b \u2264 u_max","The window of the plan, in the range of the amplifier.",l({title:"voltages",axes:["front voltage (V)","back voltage (V)"],corners:hg(r.u),outer:hg(s.amplifier),ticks:[_,_],colours:n},k=>k.u)),c("(4), (17)\u2013(20) virtual inputs","v_1 = f_f + f_b , v_2 = f_f \u2212 f_b","The window becomes a rhombus: much thrust leaves little for the difference.",l({title:"virtual inputs",axes:["thrust difference v2 (N)","thrust sum v1 (N)"],corners:A([m,y]),outer:A(S),ticks:[ho(S[0]-S[1],S[1]-S[0]),P],colours:n},k=>k.u.map(U=>ri(U,o).reverse()))),c("(25)\u2013(29) pitch limit","q_3 = \u03C8_1 ( \u03BE_1 )","The paper's smooth saturation: whatever \u03BE does, the pitch of the plan stays within its limits.",l({title:"saturation of the pitch",axes:["\u03BE (deg)","pitch (deg)"],curve:x,ticks:[N,ho(-$t(E),$t(E))],colours:n},k=>k.x.map(U=>{let se=Math.min(Math.max(U[4],-.98*E),.98*E);return[$t(b(se)),$t(se)]}))),c("(51) feedback","v = v_d \u2212 K ( t ) ( x \u2212 x_d )","Fig. 10: a start that is off, and how the feedback removes the error of the elevation.",u("elevation error","deg, positive down",this.lines,d((k,U)=>$t(k.x[U][2]-e.reference.x[U][2])),2,[-.1,.1])),...H?[c("(50), (51) gains","K ( t ) = R^\u22121 B^T P ( t )","Gains on the thrust sum, in N/rad and N s/rad; the marker names the state.",u("gains on v1","N/rad, N s/rad",D,G(0))),c("(50), (51) gains","\u2212 \u1E56 = P A + A^T P \u2212 P B R^\u22121 B^T P + Q","Gains on the thrust difference.",u("gains on v2","N/rad, N s/rad",D,G(1)),J("p",{class:"legend small"},...ud.map((k,U)=>J("span",{},ni(U,ug[U]),k))))]:[])),this.policies.forEach((k,U)=>this.setVisible(U,t[U]))}setVisible(e,t){for(let{show:n}of this.figures)n?.(e,t)}refresh(e,t,n){if(!this.experiment)return;this.flights=e;let s=n?this.figures:[this.figures[this.turn++%this.figures.length]];for(let r of s)r.refresh(),r.seek(t)}};var Ug=0,zd=1,Fg=2;var $a=1,Og=2,Oo=3,ur=0,ti=1,Ii=2,Lr=0,Bo=1,Gd=2,Vd=3,Hd=4,Bg=5;var Dr=100,kg=101,zg=102,Gg=103,Vg=104,Hg=200,Wg=201,Xg=202,qg=203,Wd=204,Xd=205,Yg=206,$g=207,Zg=208,Jg=209,Kg=210,jg=211,Qg=212,e0=213,t0=214,uc=0,hc=1,dc=2,Ao=3,fc=4,pc=5,mc=6,gc=7,Vc=0,n0=1,i0=2,cs=0,qd=1,Yd=2,$d=3,Zd=4,Jd=5,Kd=6,jd=7;var Qd=300,Nr=301,ko=302,Hc=303,Wc=304,xc=1e3,ss=1001,_c=1002,On=1003,s0=1004;var Za=1005;var Qn=1006,Xc=1007;var Is=1008;var oi=1009,ef=1010,tf=1011,zo=1012,qc=1013,Vi=1014,Hi=1015,Wi=1016,Yc=1017,$c=1018,Ur=1020,nf=35902,sf=35899,rf=1021,of=1022,Xi=1023,Rs=1026,Ls=1027,af=1028,Zc=1029,hr=1030,Jc=1031;var Kc=1033,Ja=33776,Ka=33777,ja=33778,Qa=33779,jc=35840,Qc=35841,eu=35842,tu=35843,nu=36196,iu=37492,su=37496,ru=37488,ou=37489,el=37490,au=37491,lu=37808,cu=37809,uu=37810,hu=37811,du=37812,fu=37813,pu=37814,mu=37815,gu=37816,xu=37817,_u=37818,vu=37819,yu=37820,bu=37821,Mu=36492,Su=36494,wu=36495,Tu=36283,Eu=36284,tl=36285,Au=36286;var Ea=2300,vc=2301,lc=2302,Dd=2303,Nd=2400,Ud=2401,Fd=2402;var r0=3200;var Ru=0,o0=1,Ds="",Kn="srgb",Aa="srgb-linear",Ra="linear",kt="srgb";var cc=7680;var a0=519,l0=512,c0=513,u0=514,lf=515,h0=516,d0=517,cf=518,uf=519,f0=35044;var hf="300 es",Ci=2e3,Ro=2001;function ny(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function iy(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Ca(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function p0(){let i=Ca("canvas");return i.style.display="block",i}var dg={},Co=null;function df(...i){let e="THREE."+i.shift();Co?Co("log",e,...i):console.log(e,...i)}function m0(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function ct(...i){i=m0(i);let e="THREE."+i.shift();if(Co)Co("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function dt(...i){i=m0(i);let e="THREE."+i.shift();if(Co)Co("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Ta(...i){let e=i.join(" ");e in dg||(dg[e]=!0,ct(...i))}function g0(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var x0={[uc]:uc,[dc]:mc,[fc]:fc,[Ao]:pc,[hc]:hc,[mc]:dc,[gc]:gc,[pc]:Ao},rs=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Vn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var hd=Math.PI/180,yc=180/Math.PI;function nl(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Vn[i&255]+Vn[i>>8&255]+Vn[i>>16&255]+Vn[i>>24&255]+"-"+Vn[e&255]+Vn[e>>8&255]+"-"+Vn[e>>16&15|64]+Vn[e>>24&255]+"-"+Vn[t&63|128]+Vn[t>>8&255]+"-"+Vn[t>>16&255]+Vn[t>>24&255]+Vn[n&255]+Vn[n>>8&255]+Vn[n>>16&255]+Vn[n>>24&255]).toLowerCase()}function Ct(i,e,t){return Math.max(e,Math.min(t,i))}function sy(i,e){return(i%e+e)%e}function dd(i,e,t){return(1-t)*i+t*e}function _0(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function ff(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function ry(i,e){if(e.constructor===Float32Array)return i;let t=ff(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function oy(i,e){if(e.constructor===Float32Array)return i;let t=ff(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var Tt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Ct(this.x,e.x,t.x),this.y=Ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Ct(this.x,e,t),this.y=Ct(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ct(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},os=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let c=n[s+0],l=n[s+1],u=n[s+2],d=n[s+3],h=r[o+0],f=r[o+1],p=r[o+2],_=r[o+3];if(d!==_||c!==h||l!==f||u!==p){let g=c*h+l*f+u*p+d*_;g<0&&(h=-h,f=-f,p=-p,_=-_,g=-g);let m=1-a;if(g<.9995){let y=Math.acos(g),A=Math.sin(y);m=Math.sin(m*y)/A,a=Math.sin(a*y)/A,c=c*m+h*a,l=l*m+f*a,u=u*m+p*a,d=d*m+_*a}else{c=c*m+h*a,l=l*m+f*a,u=u*m+p*a,d=d*m+_*a;let y=1/Math.sqrt(c*c+l*l+u*u+d*d);c*=y,l*=y,u*=y,d*=y}}e[t]=c,e[t+1]=l,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],u=n[s+3],d=r[o],h=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*d+c*f-l*h,e[t+1]=c*p+u*h+l*d-a*f,e[t+2]=l*p+u*f+a*h-c*d,e[t+3]=u*p-a*d-c*h-l*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,c=Math.sin,l=a(n/2),u=a(s/2),d=a(r/2),h=c(n/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=h*u*d+l*f*p,this._y=l*f*d-h*u*p,this._z=l*u*p+h*f*d,this._w=l*u*d-h*f*p;break;case"YXZ":this._x=h*u*d+l*f*p,this._y=l*f*d-h*u*p,this._z=l*u*p-h*f*d,this._w=l*u*d+h*f*p;break;case"ZXY":this._x=h*u*d-l*f*p,this._y=l*f*d+h*u*p,this._z=l*u*p+h*f*d,this._w=l*u*d-h*f*p;break;case"ZYX":this._x=h*u*d-l*f*p,this._y=l*f*d+h*u*p,this._z=l*u*p-h*f*d,this._w=l*u*d+h*f*p;break;case"YZX":this._x=h*u*d+l*f*p,this._y=l*f*d+h*u*p,this._z=l*u*p-h*f*d,this._w=l*u*d-h*f*p;break;case"XZY":this._x=h*u*d-l*f*p,this._y=l*f*d-h*u*p,this._z=l*u*p+h*f*d,this._w=l*u*d+h*f*p;break;default:ct("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],c=t[9],l=t[2],u=t[6],d=t[10],h=n+a+d;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(u-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(n>a&&n>d){let f=2*Math.sqrt(1+n-a-d);this._w=(u-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>d){let f=2*Math.sqrt(1+a-n-d);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+u)/f}else{let f=2*Math.sqrt(1+d-n-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Ct(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,c=t._y,l=t._z,u=t._w;return this._x=n*u+o*a+s*l-r*c,this._y=s*u+o*c+r*a-n*l,this._z=r*u+o*l+n*c-s*a,this._w=o*u-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let c=1-t;if(a<.9995){let l=Math.acos(a),u=Math.sin(l);c=Math.sin(c*l)/u,t=Math.sin(t*l)/u,this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this._onChangeCallback()}else this._x=this._x*c+n*t,this._y=this._y*c+s*t,this._z=this._z*c+r*t,this._w=this._w*c+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},ee=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(fg.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(fg.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,c=e.w,l=2*(o*s-a*n),u=2*(a*t-r*s),d=2*(r*n-o*t);return this.x=t+c*l+o*d-a*u,this.y=n+c*u+a*l-r*d,this.z=s+c*d+r*u-o*l,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Ct(this.x,e.x,t.x),this.y=Ct(this.y,e.y,t.y),this.z=Ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Ct(this.x,e,t),this.y=Ct(this.y,e,t),this.z=Ct(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,c=t.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return fd.copy(this).projectOnVector(e),this.sub(fd)}reflect(e){return this.sub(fd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(Ct(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},fd=new ee,fg=new os,pt=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l)}set(e,t,n,s,r,o,a,c,l){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=c,u[6]=n,u[7]=o,u[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],u=n[4],d=n[7],h=n[2],f=n[5],p=n[8],_=s[0],g=s[3],m=s[6],y=s[1],A=s[4],S=s[7],P=s[2],E=s[5],x=s[8];return r[0]=o*_+a*y+c*P,r[3]=o*g+a*A+c*E,r[6]=o*m+a*S+c*x,r[1]=l*_+u*y+d*P,r[4]=l*g+u*A+d*E,r[7]=l*m+u*S+d*x,r[2]=h*_+f*y+p*P,r[5]=h*g+f*A+p*E,r[8]=h*m+f*S+p*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8];return t*o*u-t*a*l-n*r*u+n*a*c+s*r*l-s*o*c}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8],d=u*o-a*l,h=a*c-u*r,f=l*r-o*c,p=t*d+n*h+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/p;return e[0]=d*_,e[1]=(s*l-u*n)*_,e[2]=(a*n-s*o)*_,e[3]=h*_,e[4]=(u*t-s*c)*_,e[5]=(s*r-a*t)*_,e[6]=f*_,e[7]=(n*c-l*t)*_,e[8]=(o*t-n*r)*_,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+e,-s*l,s*c,-s*(-l*o+c*a)+a+t,0,0,1),this}scale(e,t){return Ta("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(pd.makeScale(e,t)),this}rotate(e){return Ta("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(pd.makeRotation(-e)),this}translate(e,t){return Ta("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(pd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},pd=new pt,pg=new pt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),mg=new pt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ay(){let i={enabled:!0,workingColorSpace:Aa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===kt&&(s.r=As(s.r),s.g=As(s.g),s.b=As(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===kt&&(s.r=Eo(s.r),s.g=Eo(s.g),s.b=Eo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ds?Ra:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Aa]:{primaries:e,whitePoint:n,transfer:Ra,toXYZ:pg,fromXYZ:mg,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Kn},outputColorSpaceConfig:{drawingBufferColorSpace:Kn}},[Kn]:{primaries:e,whitePoint:n,transfer:kt,toXYZ:pg,fromXYZ:mg,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Kn}}}),i}var Rt=ay();function As(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function Eo(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var fo,bc=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{fo===void 0&&(fo=Ca("canvas")),fo.width=e.width,fo.height=e.height;let s=fo.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=fo}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Ca("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=As(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(As(t[n]/255)*255):t[n]=As(t[n]);return{data:t,width:e.width,height:e.height}}else return ct("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},ly=0,Po=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ly++}),this.uuid=nl(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(md(s[o].image)):r.push(md(s[o]))}else r=md(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function md(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?bc.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(ct("Texture: Unable to serialize Texture."),{})}var cy=0,gd=new ee,ei=class i extends rs{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=ss,s=ss,r=Qn,o=Is,a=Xi,c=oi,l=i.DEFAULT_ANISOTROPY,u=Ds){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:cy++}),this.uuid=nl(),this.name="",this.source=new Po(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Tt(0,0),this.repeat=new Tt(1,1),this.center=new Tt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new pt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(gd).x}get height(){return this.source.getSize(gd).y}get depth(){return this.source.getSize(gd).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){ct(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){ct(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Qd)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case xc:e.x=e.x-Math.floor(e.x);break;case ss:e.x=e.x<0?0:1;break;case _c:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case xc:e.y=e.y-Math.floor(e.y);break;case ss:e.y=e.y<0?0:1;break;case _c:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ei.DEFAULT_IMAGE=null;ei.DEFAULT_MAPPING=Qd;ei.DEFAULT_ANISOTROPY=1;var un=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,c=e.elements,l=c[0],u=c[4],d=c[8],h=c[1],f=c[5],p=c[9],_=c[2],g=c[6],m=c[10];if(Math.abs(u-h)<.01&&Math.abs(d-_)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+_)<.1&&Math.abs(p+g)<.1&&Math.abs(l+f+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let A=(l+1)/2,S=(f+1)/2,P=(m+1)/2,E=(u+h)/4,x=(d+_)/4,b=(p+g)/4;return A>S&&A>P?A<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(A),s=E/n,r=x/n):S>P?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=E/s,r=b/s):P<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(P),n=x/r,s=b/r),this.set(n,s,r,t),this}let y=Math.sqrt((g-p)*(g-p)+(d-_)*(d-_)+(h-u)*(h-u));return Math.abs(y)<.001&&(y=1),this.x=(g-p)/y,this.y=(d-_)/y,this.z=(h-u)/y,this.w=Math.acos((l+f+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Ct(this.x,e.x,t.x),this.y=Ct(this.y,e.y,t.y),this.z=Ct(this.z,e.z,t.z),this.w=Ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Ct(this.x,e,t),this.y=Ct(this.y,e,t),this.z=Ct(this.z,e,t),this.w=Ct(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Ct(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Mc=class extends rs{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Qn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new un(0,0,e,t),this.scissorTest=!1,this.viewport=new un(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new ei({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Qn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Po(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},yi=class extends Mc{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Pa=class extends ei{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Sc=class extends ei{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=ss,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var ln=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,c,l,u,d,h,f,p,_,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,c,l,u,d,h,f,p,_,g)}set(e,t,n,s,r,o,a,c,l,u,d,h,f,p,_,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=n,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=c,m[2]=l,m[6]=u,m[10]=d,m[14]=h,m[3]=f,m[7]=p,m[11]=_,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/po.setFromMatrixColumn(e,0).length(),r=1/po.setFromMatrixColumn(e,1).length(),o=1/po.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let h=o*u,f=o*d,p=a*u,_=a*d;t[0]=c*u,t[4]=-c*d,t[8]=l,t[1]=f+p*l,t[5]=h-_*l,t[9]=-a*c,t[2]=_-h*l,t[6]=p+f*l,t[10]=o*c}else if(e.order==="YXZ"){let h=c*u,f=c*d,p=l*u,_=l*d;t[0]=h+_*a,t[4]=p*a-f,t[8]=o*l,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=_+h*a,t[10]=o*c}else if(e.order==="ZXY"){let h=c*u,f=c*d,p=l*u,_=l*d;t[0]=h-_*a,t[4]=-o*d,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=_-h*a,t[2]=-o*l,t[6]=a,t[10]=o*c}else if(e.order==="ZYX"){let h=o*u,f=o*d,p=a*u,_=a*d;t[0]=c*u,t[4]=p*l-f,t[8]=h*l+_,t[1]=c*d,t[5]=_*l+h,t[9]=f*l-p,t[2]=-l,t[6]=a*c,t[10]=o*c}else if(e.order==="YZX"){let h=o*c,f=o*l,p=a*c,_=a*l;t[0]=c*u,t[4]=_-h*d,t[8]=p*d+f,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-l*u,t[6]=f*d+p,t[10]=h-_*d}else if(e.order==="XZY"){let h=o*c,f=o*l,p=a*c,_=a*l;t[0]=c*u,t[4]=-d,t[8]=l*u,t[1]=h*d+_,t[5]=o*u,t[9]=f*d-p,t[2]=p*d-f,t[6]=a*u,t[10]=_*d+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(uy,e,hy)}lookAt(e,t,n){let s=this.elements;return xi.subVectors(e,t),xi.lengthSq()===0&&(xi.z=1),xi.normalize(),Ks.crossVectors(n,xi),Ks.lengthSq()===0&&(Math.abs(n.z)===1?xi.x+=1e-4:xi.z+=1e-4,xi.normalize(),Ks.crossVectors(n,xi)),Ks.normalize(),Vl.crossVectors(xi,Ks),s[0]=Ks.x,s[4]=Vl.x,s[8]=xi.x,s[1]=Ks.y,s[5]=Vl.y,s[9]=xi.y,s[2]=Ks.z,s[6]=Vl.z,s[10]=xi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],u=n[1],d=n[5],h=n[9],f=n[13],p=n[2],_=n[6],g=n[10],m=n[14],y=n[3],A=n[7],S=n[11],P=n[15],E=s[0],x=s[4],b=s[8],N=s[12],R=s[1],L=s[5],z=s[9],H=s[13],D=s[2],G=s[6],k=s[10],U=s[14],se=s[3],X=s[7],Y=s[11],ie=s[15];return r[0]=o*E+a*R+c*D+l*se,r[4]=o*x+a*L+c*G+l*X,r[8]=o*b+a*z+c*k+l*Y,r[12]=o*N+a*H+c*U+l*ie,r[1]=u*E+d*R+h*D+f*se,r[5]=u*x+d*L+h*G+f*X,r[9]=u*b+d*z+h*k+f*Y,r[13]=u*N+d*H+h*U+f*ie,r[2]=p*E+_*R+g*D+m*se,r[6]=p*x+_*L+g*G+m*X,r[10]=p*b+_*z+g*k+m*Y,r[14]=p*N+_*H+g*U+m*ie,r[3]=y*E+A*R+S*D+P*se,r[7]=y*x+A*L+S*G+P*X,r[11]=y*b+A*z+S*k+P*Y,r[15]=y*N+A*H+S*U+P*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],c=e[9],l=e[13],u=e[2],d=e[6],h=e[10],f=e[14],p=e[3],_=e[7],g=e[11],m=e[15],y=c*f-l*h,A=a*f-l*d,S=a*h-c*d,P=o*f-l*u,E=o*h-c*u,x=o*d-a*u;return t*(_*y-g*A+m*S)-n*(p*y-g*P+m*E)+s*(p*A-_*P+m*x)-r*(p*S-_*E+g*x)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],c=e[2],l=e[6],u=e[10];return t*(o*u-a*l)-n*(r*u-a*c)+s*(r*l-o*c)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],c=e[6],l=e[7],u=e[8],d=e[9],h=e[10],f=e[11],p=e[12],_=e[13],g=e[14],m=e[15],y=t*a-n*o,A=t*c-s*o,S=t*l-r*o,P=n*c-s*a,E=n*l-r*a,x=s*l-r*c,b=u*_-d*p,N=u*g-h*p,R=u*m-f*p,L=d*g-h*_,z=d*m-f*_,H=h*m-f*g,D=y*H-A*z+S*L+P*R-E*N+x*b;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/D;return e[0]=(a*H-c*z+l*L)*G,e[1]=(s*z-n*H-r*L)*G,e[2]=(_*x-g*E+m*P)*G,e[3]=(h*E-d*x-f*P)*G,e[4]=(c*R-o*H-l*N)*G,e[5]=(t*H-s*R+r*N)*G,e[6]=(g*S-p*x-m*A)*G,e[7]=(u*x-h*S+f*A)*G,e[8]=(o*z-a*R+l*b)*G,e[9]=(n*R-t*z-r*b)*G,e[10]=(p*E-_*S+m*y)*G,e[11]=(d*S-u*E-f*y)*G,e[12]=(a*N-o*L-c*b)*G,e[13]=(t*L-n*N+s*b)*G,e[14]=(_*A-p*P-g*y)*G,e[15]=(u*P-d*A+h*y)*G,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,c=e.z,l=r*o,u=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,u*a+n,u*c-s*o,0,l*c-s*a,u*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,c=t._w,l=r+r,u=o+o,d=a+a,h=r*l,f=r*u,p=r*d,_=o*u,g=o*d,m=a*d,y=c*l,A=c*u,S=c*d,P=n.x,E=n.y,x=n.z;return s[0]=(1-(_+m))*P,s[1]=(f+S)*P,s[2]=(p-A)*P,s[3]=0,s[4]=(f-S)*E,s[5]=(1-(h+m))*E,s[6]=(g+y)*E,s[7]=0,s[8]=(p+A)*x,s[9]=(g-y)*x,s[10]=(1-(h+_))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=po.set(s[0],s[1],s[2]).length(),a=po.set(s[4],s[5],s[6]).length(),c=po.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Bi.copy(this);let l=1/o,u=1/a,d=1/c;return Bi.elements[0]*=l,Bi.elements[1]*=l,Bi.elements[2]*=l,Bi.elements[4]*=u,Bi.elements[5]*=u,Bi.elements[6]*=u,Bi.elements[8]*=d,Bi.elements[9]*=d,Bi.elements[10]*=d,t.setFromRotationMatrix(Bi),n.x=o,n.y=a,n.z=c,this}makePerspective(e,t,n,s,r,o,a=Ci,c=!1){let l=this.elements,u=2*r/(t-e),d=2*r/(n-s),h=(t+e)/(t-e),f=(n+s)/(n-s),p,_;if(c)p=r/(o-r),_=o*r/(o-r);else if(a===Ci)p=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===Ro)p=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=h,l[12]=0,l[1]=0,l[5]=d,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=_,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=Ci,c=!1){let l=this.elements,u=2/(t-e),d=2/(n-s),h=-(t+e)/(t-e),f=-(n+s)/(n-s),p,_;if(c)p=1/(o-r),_=o/(o-r);else if(a===Ci)p=-2/(o-r),_=-(o+r)/(o-r);else if(a===Ro)p=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=u,l[4]=0,l[8]=0,l[12]=h,l[1]=0,l[5]=d,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=_,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},po=new ee,Bi=new ln,uy=new ee(0,0,0),hy=new ee(1,1,1),Ks=new ee,Vl=new ee,xi=new ee,gg=new ln,xg=new os,Cs=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],u=s[9],d=s[2],h=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(Ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(Ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Ct(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(Ct(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-u,l),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:ct("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return gg.makeRotationFromQuaternion(e),this.setFromRotationMatrix(gg,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return xg.setFromEuler(this),this.setFromQuaternion(xg,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Cs.DEFAULT_ORDER="XYZ";var Ia=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},dy=0,_g=new ee,mo=new os,Ms=new ln,Hl=new ee,ba=new ee,fy=new ee,py=new os,vg=new ee(1,0,0),yg=new ee(0,1,0),bg=new ee(0,0,1),Mg={type:"added"},my={type:"removed"},go={type:"childadded",child:null},xd={type:"childremoved",child:null},Wn=class i extends rs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:dy++}),this.uuid=nl(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new ee,t=new Cs,n=new os,s=new ee(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ln},normalMatrix:{value:new pt}}),this.matrix=new ln,this.matrixWorld=new ln,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ia,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return mo.setFromAxisAngle(e,t),this.quaternion.multiply(mo),this}rotateOnWorldAxis(e,t){return mo.setFromAxisAngle(e,t),this.quaternion.premultiply(mo),this}rotateX(e){return this.rotateOnAxis(vg,e)}rotateY(e){return this.rotateOnAxis(yg,e)}rotateZ(e){return this.rotateOnAxis(bg,e)}translateOnAxis(e,t){return _g.copy(e).applyQuaternion(this.quaternion),this.position.add(_g.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(vg,e)}translateY(e){return this.translateOnAxis(yg,e)}translateZ(e){return this.translateOnAxis(bg,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ms.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Hl.copy(e):Hl.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),ba.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ms.lookAt(ba,Hl,this.up):Ms.lookAt(Hl,ba,this.up),this.quaternion.setFromRotationMatrix(Ms),s&&(Ms.extractRotation(s.matrixWorld),mo.setFromRotationMatrix(Ms),this.quaternion.premultiply(mo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(dt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Mg),go.child=e,this.dispatchEvent(go),go.child=null):dt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(my),xd.child=e,this.dispatchEvent(xd),xd.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ms.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ms.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ms),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Mg),go.child=e,this.dispatchEvent(go),go.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ba,e,fy),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ba,py,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(e)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,u=c.length;l<u;l++){let d=c[l];r(e.shapes,d)}else r(e.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(e.materials,this.material[c]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(e.animations,c))}}if(t){let a=o(e.geometries),c=o(e.materials),l=o(e.textures),u=o(e.images),d=o(e.shapes),h=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),u.length>0&&(n.images=u),d.length>0&&(n.shapes=d),h.length>0&&(n.skeletons=h),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let c=[];for(let l in a){let u=a[l];delete u.metadata,c.push(u)}return c}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Wn.DEFAULT_UP=new ee(0,1,0);Wn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Wn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var vi=class extends Wn{constructor(){super(),this.isGroup=!0,this.type="Group"}},gy={type:"move"},Io=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new vi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new vi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new ee,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new ee),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new vi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new ee,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new ee,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(l&&e.hand){o=!0;for(let _ of e.hand.values()){let g=t.getJointPose(_,n),m=this._getHandJoint(l,_);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=l.joints["index-finger-tip"],d=l.joints["thumb-tip"],h=u.position.distanceTo(d.position),f=.02,p=.005;l.inputState.pinching&&h>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!l.inputState.pinching&&h<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else c!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(gy)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new vi;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},v0={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},js={h:0,s:0,l:0},Wl={h:0,s:0,l:0};function _d(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var yt=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Kn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,Rt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=Rt.workingColorSpace){return this.r=e,this.g=t,this.b=n,Rt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=Rt.workingColorSpace){if(e=sy(e,1),t=Ct(t,0,1),n=Ct(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=_d(o,r,e+1/3),this.g=_d(o,r,e),this.b=_d(o,r,e-1/3)}return Rt.colorSpaceToWorking(this,s),this}setStyle(e,t=Kn){function n(r){r!==void 0&&parseFloat(r)<1&&ct("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:ct("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);ct("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Kn){let n=v0[e.toLowerCase()];return n!==void 0?this.setHex(n,t):ct("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=As(e.r),this.g=As(e.g),this.b=As(e.b),this}copyLinearToSRGB(e){return this.r=Eo(e.r),this.g=Eo(e.g),this.b=Eo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Kn){return Rt.workingToColorSpace(Hn.copy(this),e),Math.round(Ct(Hn.r*255,0,255))*65536+Math.round(Ct(Hn.g*255,0,255))*256+Math.round(Ct(Hn.b*255,0,255))}getHexString(e=Kn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=Rt.workingColorSpace){Rt.workingToColorSpace(Hn.copy(this),t);let n=Hn.r,s=Hn.g,r=Hn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,u=(a+o)/2;if(a===o)c=0,l=0;else{let d=o-a;switch(l=u<=.5?d/(o+a):d/(2-o-a),o){case n:c=(s-r)/d+(s<r?6:0);break;case s:c=(r-n)/d+2;break;case r:c=(n-s)/d+4;break}c/=6}return e.h=c,e.s=l,e.l=u,e}getRGB(e,t=Rt.workingColorSpace){return Rt.workingToColorSpace(Hn.copy(this),t),e.r=Hn.r,e.g=Hn.g,e.b=Hn.b,e}getStyle(e=Kn){Rt.workingToColorSpace(Hn.copy(this),e);let t=Hn.r,n=Hn.g,s=Hn.b;return e!==Kn?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(js),this.setHSL(js.h+e,js.s+t,js.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(js),e.getHSL(Wl);let n=dd(js.h,Wl.h,t),s=dd(js.s,Wl.s,t),r=dd(js.l,Wl.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Hn=new yt;yt.NAMES=v0;var La=class extends Wn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Cs,this.environmentIntensity=1,this.environmentRotation=new Cs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ki=new ee,Ss=new ee,vd=new ee,ws=new ee,xo=new ee,_o=new ee,Sg=new ee,yd=new ee,bd=new ee,Md=new ee,Sd=new un,wd=new un,Td=new un,nr=class i{constructor(e=new ee,t=new ee,n=new ee){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),ki.subVectors(e,t),s.cross(ki);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){ki.subVectors(s,t),Ss.subVectors(n,t),vd.subVectors(e,t);let o=ki.dot(ki),a=ki.dot(Ss),c=ki.dot(vd),l=Ss.dot(Ss),u=Ss.dot(vd),d=o*l-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,f=(l*c-a*u)*h,p=(o*u-a*c)*h;return r.set(1-f-p,p,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ws)===null?!1:ws.x>=0&&ws.y>=0&&ws.x+ws.y<=1}static getInterpolation(e,t,n,s,r,o,a,c){return this.getBarycoord(e,t,n,s,ws)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,ws.x),c.addScaledVector(o,ws.y),c.addScaledVector(a,ws.z),c)}static getInterpolatedAttribute(e,t,n,s,r,o){return Sd.setScalar(0),wd.setScalar(0),Td.setScalar(0),Sd.fromBufferAttribute(e,t),wd.fromBufferAttribute(e,n),Td.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Sd,r.x),o.addScaledVector(wd,r.y),o.addScaledVector(Td,r.z),o}static isFrontFacing(e,t,n,s){return ki.subVectors(n,t),Ss.subVectors(e,t),ki.cross(Ss).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ki.subVectors(this.c,this.b),Ss.subVectors(this.a,this.b),ki.cross(Ss).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;xo.subVectors(s,n),_o.subVectors(r,n),yd.subVectors(e,n);let c=xo.dot(yd),l=_o.dot(yd);if(c<=0&&l<=0)return t.copy(n);bd.subVectors(e,s);let u=xo.dot(bd),d=_o.dot(bd);if(u>=0&&d<=u)return t.copy(s);let h=c*d-u*l;if(h<=0&&c>=0&&u<=0&&c-u>0)return o=c/(c-u),t.copy(n).addScaledVector(xo,o);Md.subVectors(e,r);let f=xo.dot(Md),p=_o.dot(Md);if(p>=0&&f<=p)return t.copy(r);let _=f*l-c*p;if(_<=0&&l>=0&&p<=0)return a=l/(l-p),t.copy(n).addScaledVector(_o,a);let g=u*p-f*d;if(g<=0&&d-u>=0&&f-p>=0)return Sg.subVectors(r,s),a=(d-u)/(d-u+(f-p)),t.copy(s).addScaledVector(Sg,a);let m=1/(g+_+h);return o=_*m,a=h*m,t.copy(n).addScaledVector(xo,o).addScaledVector(_o,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ir=class{constructor(e=new ee(1/0,1/0,1/0),t=new ee(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(zi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(zi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=zi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,zi):zi.fromBufferAttribute(r,o),zi.applyMatrix4(e.matrixWorld),this.expandByPoint(zi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Xl.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Xl.copy(n.boundingBox)),Xl.applyMatrix4(e.matrixWorld),this.union(Xl)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,zi),zi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ma),ql.subVectors(this.max,Ma),vo.subVectors(e.a,Ma),yo.subVectors(e.b,Ma),bo.subVectors(e.c,Ma),Qs.subVectors(yo,vo),er.subVectors(bo,yo),Rr.subVectors(vo,bo);let t=[0,-Qs.z,Qs.y,0,-er.z,er.y,0,-Rr.z,Rr.y,Qs.z,0,-Qs.x,er.z,0,-er.x,Rr.z,0,-Rr.x,-Qs.y,Qs.x,0,-er.y,er.x,0,-Rr.y,Rr.x,0];return!Ed(t,vo,yo,bo,ql)||(t=[1,0,0,0,1,0,0,0,1],!Ed(t,vo,yo,bo,ql))?!1:(Yl.crossVectors(Qs,er),t=[Yl.x,Yl.y,Yl.z],Ed(t,vo,yo,bo,ql))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,zi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(zi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Ts[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Ts[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Ts[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Ts[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Ts[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Ts[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Ts[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Ts[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Ts),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Ts=[new ee,new ee,new ee,new ee,new ee,new ee,new ee,new ee],zi=new ee,Xl=new ir,vo=new ee,yo=new ee,bo=new ee,Qs=new ee,er=new ee,Rr=new ee,Ma=new ee,ql=new ee,Yl=new ee,Cr=new ee;function Ed(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Cr.fromArray(i,r);let a=s.x*Math.abs(Cr.x)+s.y*Math.abs(Cr.y)+s.z*Math.abs(Cr.z),c=e.dot(Cr),l=t.dot(Cr),u=n.dot(Cr);if(Math.max(-Math.max(c,l,u),Math.min(c,l,u))>a)return!1}return!0}var Mn=new ee,$l=new Tt,xy=0,Pi=class extends rs{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:xy++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=f0,this.updateRanges=[],this.gpuType=Hi,this.version=0,this._normalizationScale=e!==void 0?ff(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)$l.fromBufferAttribute(this,t),$l.applyMatrix3(e),this.setXY(t,$l.x,$l.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyMatrix3(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyMatrix4(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.applyNormalMatrix(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)Mn.fromBufferAttribute(this,t),Mn.transformDirection(e),this.setXYZ(t,Mn.x,Mn.y,Mn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):ry(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):oy(e,this.array)}};var Da=class extends Pi{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Na=class extends Pi{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var cn=class extends Pi{constructor(e,t,n){super(new Float32Array(e),t,n)}},_y=new ir,Sa=new ee,Ad=new ee,Lo=class{constructor(e=new ee,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):_y.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Sa.subVectors(e,this.center);let t=Sa.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Sa,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Ad.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Sa.copy(e.center).add(Ad)),this.expandByPoint(Sa.copy(e.center).sub(Ad))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},vy=0,Ri=new ln,Rd=new Wn,Mo=new ee,_i=new ir,wa=new ir,Fn=new ee,bi=class i extends rs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:vy++}),this.uuid=nl(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(ny(e)?Na:Da)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new pt().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ri.makeRotationFromQuaternion(e),this.applyMatrix4(Ri),this}rotateX(e){return Ri.makeRotationX(e),this.applyMatrix4(Ri),this}rotateY(e){return Ri.makeRotationY(e),this.applyMatrix4(Ri),this}rotateZ(e){return Ri.makeRotationZ(e),this.applyMatrix4(Ri),this}translate(e,t,n){return Ri.makeTranslation(e,t,n),this.applyMatrix4(Ri),this}scale(e,t,n){return Ri.makeScale(e,t,n),this.applyMatrix4(Ri),this}lookAt(e){return Rd.lookAt(e),Rd.updateMatrix(),this.applyMatrix4(Rd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Mo).negate(),this.translate(Mo.x,Mo.y,Mo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new cn(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&ct("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ir);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){dt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new ee(-1/0,-1/0,-1/0),new ee(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];_i.setFromBufferAttribute(r),this.morphTargetsRelative?(Fn.addVectors(this.boundingBox.min,_i.min),this.boundingBox.expandByPoint(Fn),Fn.addVectors(this.boundingBox.max,_i.max),this.boundingBox.expandByPoint(Fn)):(this.boundingBox.expandByPoint(_i.min),this.boundingBox.expandByPoint(_i.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&dt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Lo);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){dt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new ee,1/0);return}if(e){let n=this.boundingSphere.center;if(_i.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];wa.setFromBufferAttribute(a),this.morphTargetsRelative?(Fn.addVectors(_i.min,wa.min),_i.expandByPoint(Fn),Fn.addVectors(_i.max,wa.max),_i.expandByPoint(Fn)):(_i.expandByPoint(wa.min),_i.expandByPoint(wa.max))}_i.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)Fn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Fn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],c=this.morphTargetsRelative;for(let l=0,u=a.count;l<u;l++)Fn.fromBufferAttribute(a,l),c&&(Mo.fromBufferAttribute(e,l),Fn.add(Mo)),s=Math.max(s,n.distanceToSquared(Fn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&dt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){dt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new Pi(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let N=0;N<n.count;N++)a[N]=new ee,c[N]=new ee;let u=new ee,d=new ee,h=new ee,f=new Tt,p=new Tt,_=new Tt,g=new ee,m=new ee;function y(N,R,L){l[N]=l[R]=l[L]=1,u.fromBufferAttribute(n,N),d.fromBufferAttribute(n,R),h.fromBufferAttribute(n,L),f.fromBufferAttribute(r,N),p.fromBufferAttribute(r,R),_.fromBufferAttribute(r,L),d.sub(u),h.sub(u),p.sub(f),_.sub(f);let z=1/(p.x*_.y-_.x*p.y);isFinite(z)&&(g.copy(d).multiplyScalar(_.y).addScaledVector(h,-p.y).multiplyScalar(z),m.copy(h).multiplyScalar(p.x).addScaledVector(d,-_.x).multiplyScalar(z),a[N].add(g),a[R].add(g),a[L].add(g),c[N].add(m),c[R].add(m),c[L].add(m))}let A=this.groups;A.length===0&&(A=[{start:0,count:e.count}]);for(let N=0,R=A.length;N<R;++N){let L=A[N],z=L.start,H=L.count;for(let D=z,G=z+H;D<G;D+=3)y(e.getX(D+0),e.getX(D+1),e.getX(D+2))}let S=new ee,P=new ee,E=new ee,x=new ee;function b(N){E.fromBufferAttribute(s,N),x.copy(E);let R=a[N];S.copy(R),S.sub(E.multiplyScalar(E.dot(R))).normalize(),P.crossVectors(x,R);let z=P.dot(c[N])<0?-1:1;o.setXYZW(N,S.x,S.y,S.z,z)}for(let N=0,R=n.count;N<R;++N)l[N]&&b(N);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new Pi(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let h=0,f=n.count;h<f;h++)n.setXYZ(h,0,0,0);let s=new ee,r=new ee,o=new ee,a=new ee,c=new ee,l=new ee,u=new ee,d=new ee;if(e)for(let h=0,f=e.count;h<f;h+=3){let p=e.getX(h+0),_=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,_),o.fromBufferAttribute(t,g),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(n,p),c.fromBufferAttribute(n,_),l.fromBufferAttribute(n,g),a.add(u),c.add(u),l.add(u),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(_,c.x,c.y,c.z),n.setXYZ(g,l.x,l.y,l.z)}else for(let h=0,f=t.count;h<f;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),n.setXYZ(h+0,u.x,u.y,u.z),n.setXYZ(h+1,u.x,u.y,u.z),n.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)Fn.fromBufferAttribute(e,t),Fn.normalize(),e.setXYZ(t,Fn.x,Fn.y,Fn.z)}toNonIndexed(){function e(a,c){let l=a.array,u=a.itemSize,d=a.normalized,h=new l.constructor(c.length*u),f=0,p=0;for(let _=0,g=c.length;_<g;_++){a.isInterleavedBufferAttribute?f=c[_]*a.data.stride+a.offset:f=c[_]*u;for(let m=0;m<u;m++)h[p++]=l[f++]}return new Pi(h,u,d)}if(this.index===null)return ct("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=e(c,n);t.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let u=0,d=l.length;u<d;u++){let h=l[u],f=e(h,n);c.push(f)}t.morphAttributes[a]=c}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];t.addGroup(l.start,l.count,l.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(e[l]=c[l]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let c in n){let l=n[c];e.data.attributes[c]=l.toJSON(e.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],u=[];for(let d=0,h=l.length;d<h;d++){let f=l[d];u.push(f.toJSON(e.data))}u.length>0&&(s[c]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let l in s){let u=s[l];this.setAttribute(l,u.clone(t))}let r=e.morphAttributes;for(let l in r){let u=[],d=r[l];for(let h=0,f=d.length;h<f;h++)u.push(d[h].clone(t));this.morphAttributes[l]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let l=0,u=o.length;l<u;l++){let d=o[l];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=e.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Cd=new ee,yy=new ee,by=new pt,Gi=class{constructor(e=new ee(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=Cd.subVectors(n,t).cross(yy.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta(Cd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||by.getNormalMatrix(e),s=this.coplanarPoint(Cd).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},My=0,sr=class extends rs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:My++}),this.uuid=nl(),this.name="",this.type="Material",this.blending=Bo,this.side=ur,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Wd,this.blendDst=Xd,this.blendEquation=Dr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new yt(0,0,0),this.blendAlpha=0,this.depthFunc=Ao,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=a0,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=cc,this.stencilZFail=cc,this.stencilZPass=cc,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){ct(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){ct(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new yt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new Gi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Tt().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Tt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Es=new ee,Pd=new ee,Zl=new ee,Jl=new ee,wc=class{constructor(e=new ee,t=new ee(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Es)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Es.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Es.copy(this.origin).addScaledVector(this.direction,t),Es.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Pd.copy(e).add(t).multiplyScalar(.5),Zl.copy(t).sub(e).normalize(),Jl.copy(this.origin).sub(Pd);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Zl),a=Jl.dot(this.direction),c=-Jl.dot(Zl),l=Jl.lengthSq(),u=Math.abs(1-o*o),d,h,f,p;if(u>0)if(d=o*c-a,h=o*a-c,p=r*u,d>=0)if(h>=-p)if(h<=p){let _=1/u;d*=_,h*=_,f=d*(d+o*h+2*a)+h*(o*d+h+2*c)+l}else h=r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*c)+l;else h=-r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*c)+l;else h<=-p?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-c),r),f=-d*d+h*(h+2*c)+l):h<=p?(d=0,h=Math.min(Math.max(-r,-c),r),f=h*(h+2*c)+l):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-c),r),f=-d*d+h*(h+2*c)+l);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(Pd).addScaledVector(Zl,h),f}intersectSphere(e,t){if(e.radius<0)return null;Es.subVectors(e.center,this.origin);let n=Es.dot(this.direction),s=Es.dot(Es)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,c,l=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return l>=0?(n=(e.min.x-h.x)*l,s=(e.max.x-h.x)*l):(n=(e.max.x-h.x)*l,s=(e.min.x-h.x)*l),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-h.z)*d,c=(e.max.z-h.z)*d):(a=(e.max.z-h.z)*d,c=(e.min.z-h.z)*d),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,Es)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,u=a.z,d=e.x-o.x,h=e.y-o.y,f=e.z-o.z,p=t.x-o.x,_=t.y-o.y,g=t.z-o.z,m=n.x-o.x,y=n.y-o.y,A=n.z-o.z,S=Math.abs(c),P=Math.abs(l),E=Math.abs(u),x,b,N,R,L,z,H,D,G,k,U,se;if(S>=P&&S>=E?(N=c,z=d,G=p,se=m,c>=0?(x=l,b=u,R=h,L=f,H=_,D=g,k=y,U=A):(x=u,b=l,R=f,L=h,H=g,D=_,k=A,U=y)):P>=E?(N=l,z=h,G=_,se=y,l>=0?(x=u,b=c,R=f,L=d,H=g,D=p,k=A,U=m):(x=c,b=u,R=d,L=f,H=p,D=g,k=m,U=A)):(N=u,z=f,G=g,se=A,u>=0?(x=c,b=l,R=d,L=h,H=p,D=_,k=m,U=y):(x=l,b=c,R=h,L=d,H=_,D=p,k=y,U=m)),N===0)return null;let X=x/N,Y=b/N,ie=1/N,ce=R-X*z,he=L-Y*z,Q=H-X*G,ge=D-Y*G,_e=k-X*se,Te=U-Y*se,xe=_e*ge-Te*Q,Ge=ce*Te-he*_e,qe=Q*he-ge*ce;if(s){if(xe<0||Ge<0||qe<0)return null}else if((xe<0||Ge<0||qe<0)&&(xe>0||Ge>0||qe>0))return null;let ke=xe+Ge+qe;if(ke===0)return null;let it=ie*(xe*z+Ge*G+qe*se);return(ke>0?it<0:it>0)?null:this.at(it/ke,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},as=class extends sr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new yt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cs,this.combine=Vc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},wg=new ln,Pr=new wc,Kl=new Lo,Tg=new ee,jl=new ee,Ql=new ee,ec=new ee,Id=new ee,tc=new ee,Eg=new ee,nc=new ee,Bn=class extends Wn{constructor(e=new bi,t=new as){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){tc.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let u=a[c],d=r[c];u!==0&&(Id.fromBufferAttribute(d,e),o?tc.addScaledVector(Id,u):tc.addScaledVector(Id.sub(t),u))}t.add(tc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Kl.copy(n.boundingSphere),Kl.applyMatrix4(r),Pr.copy(e.ray).recast(e.near),!(Kl.containsPoint(Pr.origin)===!1&&(Pr.intersectSphere(Kl,Tg)===null||Pr.origin.distanceToSquared(Tg)>(e.far-e.near)**2))&&(wg.copy(r).invert(),Pr.copy(e.ray).applyMatrix4(wg),!(n.boundingBox!==null&&Pr.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Pr)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,_=h.length;p<_;p++){let g=h[p],m=o[g.materialIndex],y=Math.max(g.start,f.start),A=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let S=y,P=A;S<P;S+=3){let E=a.getX(S),x=a.getX(S+1),b=a.getX(S+2);s=ic(this,m,e,n,l,u,d,E,x,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(a.count,f.start+f.count);for(let g=p,m=_;g<m;g+=3){let y=a.getX(g),A=a.getX(g+1),S=a.getX(g+2);s=ic(this,o,e,n,l,u,d,y,A,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,_=h.length;p<_;p++){let g=h[p],m=o[g.materialIndex],y=Math.max(g.start,f.start),A=Math.min(c.count,Math.min(g.start+g.count,f.start+f.count));for(let S=y,P=A;S<P;S+=3){let E=S,x=S+1,b=S+2;s=ic(this,m,e,n,l,u,d,E,x,b),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),_=Math.min(c.count,f.start+f.count);for(let g=p,m=_;g<m;g+=3){let y=g,A=g+1,S=g+2;s=ic(this,o,e,n,l,u,d,y,A,S),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function Sy(i,e,t,n,s,r,o,a){let c;if(e.side===ti?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,e.side===ur,a),c===null)return null;nc.copy(a),nc.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(nc);return l<t.near||l>t.far?null:{distance:l,point:nc.clone(),object:i}}function ic(i,e,t,n,s,r,o,a,c,l){i.getVertexPosition(a,jl),i.getVertexPosition(c,Ql),i.getVertexPosition(l,ec);let u=Sy(i,e,t,n,jl,Ql,ec,Eg);if(u){let d=new ee;nr.getBarycoord(Eg,jl,Ql,ec,d),s&&(u.uv=nr.getInterpolatedAttribute(s,a,c,l,d,new Tt)),r&&(u.uv1=nr.getInterpolatedAttribute(r,a,c,l,d,new Tt)),o&&(u.normal=nr.getInterpolatedAttribute(o,a,c,l,d,new ee),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:c,c:l,normal:new ee,materialIndex:0};nr.getNormal(jl,Ql,ec,h.normal),u.face=h,u.barycoord=d}return u}var Tc=class extends ei{constructor(e=null,t=1,n=1,s,r,o,a,c,l=On,u=On,d,h){super(null,o,a,c,l,u,s,r,d,h),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ir=new Lo,wy=new Tt(.5,.5),sc=new ee,rr=class{constructor(e=new Gi,t=new Gi,n=new Gi,s=new Gi,r=new Gi,o=new Gi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=Ci,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],c=r[2],l=r[3],u=r[4],d=r[5],h=r[6],f=r[7],p=r[8],_=r[9],g=r[10],m=r[11],y=r[12],A=r[13],S=r[14],P=r[15];if(s[0].setComponents(l-o,f-u,m-p,P-y).normalize(),s[1].setComponents(l+o,f+u,m+p,P+y).normalize(),s[2].setComponents(l+a,f+d,m+_,P+A).normalize(),s[3].setComponents(l-a,f-d,m-_,P-A).normalize(),n)s[4].setComponents(c,h,g,S).normalize(),s[5].setComponents(l-c,f-h,m-g,P-S).normalize();else if(s[4].setComponents(l-c,f-h,m-g,P-S).normalize(),t===Ci)s[5].setComponents(l+c,f+h,m+g,P+S).normalize();else if(t===Ro)s[5].setComponents(c,h,g,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Ir.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Ir.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Ir)}intersectsSprite(e){Ir.center.set(0,0,0);let t=wy.distanceTo(e.center);return Ir.radius=.7071067811865476+t,Ir.applyMatrix4(e.matrixWorld),this.intersectsSphere(Ir)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(sc.x=s.normal.x>0?e.max.x:e.min.x,sc.y=s.normal.y>0?e.max.y:e.min.y,sc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(sc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Ag=new ln,Ec=class i{constructor(){this.coordinateSystem=Ci,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Ag.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new rr),n[s].setFromProjectionMatrix(Ag,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new rr),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ua=class extends ei{constructor(e=[],t=Nr,n,s,r,o,a,c,l,u){super(e,t,n,s,r,o,a,c,l,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}},Fa=class extends ei{constructor(e,t,n,s,r,o,a,c,l){super(e,t,n,s,r,o,a,c,l),this.isCanvasTexture=!0,this.needsUpdate=!0}};var Ps=class extends ei{constructor(e,t,n=Vi,s,r,o,a=On,c=On,l,u=Rs,d=1){if(u!==Rs&&u!==Ls)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:d};super(h,s,r,o,a,c,u,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Po(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Oa=class extends Ps{constructor(e,t=Vi,n=Nr,s,r,o=On,a=On,c,l=Rs){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,c,l),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Ba=class extends ei{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},or=class i extends bi{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],u=[],d=[],h=0,f=0;p("z","y","x",-1,-1,n,t,e,o,r,0),p("z","y","x",1,-1,n,t,-e,o,r,1),p("x","z","y",1,1,e,n,t,s,o,2),p("x","z","y",1,-1,e,n,-t,s,o,3),p("x","y","z",1,-1,e,t,n,s,r,4),p("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new cn(l,3)),this.setAttribute("normal",new cn(u,3)),this.setAttribute("uv",new cn(d,2));function p(_,g,m,y,A,S,P,E,x,b,N){let R=S/x,L=P/b,z=S/2,H=P/2,D=E/2,G=x+1,k=b+1,U=0,se=0,X=new ee;for(let Y=0;Y<k;Y++){let ie=Y*L-H;for(let ce=0;ce<G;ce++){let he=ce*R-z;X[_]=he*y,X[g]=ie*A,X[m]=D,l.push(X.x,X.y,X.z),X[_]=0,X[g]=0,X[m]=E>0?1:-1,u.push(X.x,X.y,X.z),d.push(ce/x),d.push(1-Y/b),U+=1}}for(let Y=0;Y<b;Y++)for(let ie=0;ie<x;ie++){let ce=h+ie+G*Y,he=h+ie+G*(Y+1),Q=h+(ie+1)+G*(Y+1),ge=h+(ie+1)+G*Y;c.push(ce,he,ge),c.push(he,Q,ge),se+=6}a.addGroup(f,se,N),f+=se,h+=U}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Do=class i extends bi{constructor(e=1,t=32,n=0,s=Math.PI*2){super(),this.type="CircleGeometry",this.parameters={radius:e,segments:t,thetaStart:n,thetaLength:s},t=Math.max(3,t);let r=[],o=[],a=[],c=[],l=new ee,u=new Tt;o.push(0,0,0),a.push(0,0,1),c.push(.5,.5);for(let d=0,h=3;d<=t;d++,h+=3){let f=n+d/t*s;l.x=e*Math.cos(f),l.y=e*Math.sin(f),o.push(l.x,l.y,l.z),a.push(0,0,1),u.x=(o[h]/e+1)/2,u.y=(o[h+1]/e+1)/2,c.push(u.x,u.y)}for(let d=1;d<=t;d++)r.push(d,d+1,0);this.setIndex(r),this.setAttribute("position",new cn(o,3)),this.setAttribute("normal",new cn(a,3)),this.setAttribute("uv",new cn(c,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.segments,e.thetaStart,e.thetaLength)}},No=class i extends bi{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let u=[],d=[],h=[],f=[],p=0,_=[],g=n/2,m=0;y(),o===!1&&(e>0&&A(!0),t>0&&A(!1)),this.setIndex(u),this.setAttribute("position",new cn(d,3)),this.setAttribute("normal",new cn(h,3)),this.setAttribute("uv",new cn(f,2));function y(){let S=new ee,P=new ee,E=0,x=(t-e)/n;for(let b=0;b<=r;b++){let N=[],R=b/r,L=R*(t-e)+e;for(let z=0;z<=s;z++){let H=z/s,D=H*c+a,G=Math.sin(D),k=Math.cos(D);P.x=L*G,P.y=-R*n+g,P.z=L*k,d.push(P.x,P.y,P.z),S.set(G,x,k).normalize(),h.push(S.x,S.y,S.z),f.push(H,1-R),N.push(p++)}_.push(N)}for(let b=0;b<s;b++)for(let N=0;N<r;N++){let R=_[N][b],L=_[N+1][b],z=_[N+1][b+1],H=_[N][b+1];(e>0||N!==0)&&(u.push(R,L,H),E+=3),(t>0||N!==r-1)&&(u.push(L,z,H),E+=3)}l.addGroup(m,E,0),m+=E}function A(S){let P=p,E=new Tt,x=new ee,b=0,N=S===!0?e:t,R=S===!0?1:-1;for(let z=1;z<=s;z++)d.push(0,g*R,0),h.push(0,R,0),f.push(.5,.5),p++;let L=p;for(let z=0;z<=s;z++){let D=z/s*c+a,G=Math.cos(D),k=Math.sin(D);x.x=N*k,x.y=g*R,x.z=N*G,d.push(x.x,x.y,x.z),h.push(0,R,0),E.x=G*.5+.5,E.y=k*.5*R+.5,f.push(E.x,E.y),p++}for(let z=0;z<s;z++){let H=P+z,D=L+z;S===!0?u.push(D,D+1,H):u.push(D+1,D,H),b+=3}l.addGroup(m,b,S===!0?1:2),m+=b}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},ka=class i extends No{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var za=class i extends bi{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),c=Math.floor(s),l=a+1,u=c+1,d=e/a,h=t/c,f=[],p=[],_=[],g=[];for(let m=0;m<u;m++){let y=m*h-o;for(let A=0;A<l;A++){let S=A*d-r;p.push(S,-y,0),_.push(0,0,1),g.push(A/a),g.push(1-m/c)}}for(let m=0;m<c;m++)for(let y=0;y<a;y++){let A=y+l*m,S=y+l*(m+1),P=y+1+l*(m+1),E=y+1+l*m;f.push(A,S,E),f.push(S,P,E)}this.setIndex(f),this.setAttribute("position",new cn(p,3)),this.setAttribute("normal",new cn(_,3)),this.setAttribute("uv",new cn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var Ga=class i extends bi{constructor(e=1,t=.4,n=12,s=48,r=Math.PI*2,o=0,a=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:e,tube:t,radialSegments:n,tubularSegments:s,arc:r,thetaStart:o,thetaLength:a},n=Math.floor(n),s=Math.floor(s);let c=[],l=[],u=[],d=[],h=new ee,f=new ee,p=new ee;for(let _=0;_<=n;_++){let g=o+_/n*a;for(let m=0;m<=s;m++){let y=m/s*r;f.x=(e+t*Math.cos(g))*Math.cos(y),f.y=(e+t*Math.cos(g))*Math.sin(y),f.z=t*Math.sin(g),l.push(f.x,f.y,f.z),h.x=e*Math.cos(y),h.y=e*Math.sin(y),p.subVectors(f,h).normalize(),u.push(p.x,p.y,p.z),d.push(m/s),d.push(_/n)}}for(let _=1;_<=n;_++)for(let g=1;g<=s;g++){let m=(s+1)*_+g-1,y=(s+1)*(_-1)+g-1,A=(s+1)*(_-1)+g,S=(s+1)*_+g;c.push(m,y,S),c.push(y,A,S)}this.setIndex(c),this.setAttribute("position",new cn(l,3)),this.setAttribute("normal",new cn(u,3)),this.setAttribute("uv",new cn(d,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.tube,e.radialSegments,e.tubularSegments,e.arc,e.thetaStart,e.thetaLength)}};function Fr(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Rg(s))s.isRenderTargetTexture?(ct("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Rg(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Xn(i){let e={};for(let t=0;t<i.length;t++){let n=Fr(i[t]);for(let s in n)e[s]=n[s]}return e}function Rg(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Ty(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function pf(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:Rt.workingColorSpace}var y0={clone:Fr,merge:Xn},Ey=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ay=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ls=class extends sr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ey,this.fragmentShader=Ay,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Fr(e.uniforms),this.uniformsGroups=Ty(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new yt().setHex(s.value);break;case"v2":this.uniforms[n].value=new Tt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new ee().fromArray(s.value);break;case"v4":this.uniforms[n].value=new un().fromArray(s.value);break;case"m3":this.uniforms[n].value=new pt().fromArray(s.value);break;case"m4":this.uniforms[n].value=new ln().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Ac=class extends ls{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Uo=class extends sr{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new yt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new yt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ru,this.normalScale=new Tt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Cs,this.combine=Vc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Rc=class extends sr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=r0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Cc=class extends sr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function So(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function rc(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var ar=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Pc=class extends ar{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Nd,endingEnd:Nd}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Ud:r=e,a=2*t-n;break;case Fd:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Ud:o=e,c=2*n-t;break;case Fd:o=1,c=n+s[1]-s[0];break;default:o=e-1,c=t}let l=(n-t)*.5,u=this.valueSize;this._weightPrev=l/(t-a),this._weightNext=l/(c-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,f=this._weightNext,p=(n-t)/(s-t),_=p*p,g=_*p,m=-h*g+2*h*_-h*p,y=(1+h)*g+(-1.5-2*h)*_+(-.5+h)*p+1,A=(-1-f)*g+(1.5+f)*_+.5*p,S=f*g-f*_;for(let P=0;P!==a;++P)r[P]=m*o[u+P]+y*o[l+P]+A*o[c+P]+S*o[d+P];return r}},Ic=class extends ar{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=(n-t)/(s-t),d=1-u;for(let h=0;h!==a;++h)r[h]=o[l+h]*d+o[c+h]*u;return r}},Lc=class extends ar{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Dc=class extends ar{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=e*a,l=c-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let p=(n-t)/(s-t),_=1-p;for(let g=0;g!==a;++g)r[g]=o[l+g]*_+o[c+g]*p;return r}let h=a*2,f=e-1;for(let p=0;p!==a;++p){let _=o[l+p],g=o[c+p],m=f*h+p*2,y=d[m],A=d[m+1],S=e*h+p*2,P=u[S],E=u[S+1],x=Cy(n,t,y,P,s);r[p]=b0(x,_,A,E,g)}return r}};function b0(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function Ry(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function Cy(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=b0(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let c=Ry(r,e,t,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var Mi=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=So(t,this.TimeBufferType),this.values=So(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:So(e.times,Array),values:So(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),rc(e.settings)&&(n.settings={inTangents:So(e.settings.inTangents,Array),outTangents:So(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Lc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Ic(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Pc(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Dc(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ea:t=this.InterpolantFactoryMethodDiscrete;break;case vc:t=this.InterpolantFactoryMethodLinear;break;case lc:t=this.InterpolantFactoryMethodSmooth;break;case Dd:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return ct("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ea;case this.InterpolantFactoryMethodLinear:return vc;case this.InterpolantFactoryMethodSmooth:return lc;case this.InterpolantFactoryMethodBezier:return Dd}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;rc(this.settings)&&(Cg(this.settings.inTangents,e),Cg(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;rc(this.settings)&&(Pg(this.settings.inTangents,e),Pg(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(dt("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(dt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){dt("KeyframeTrack: Time is not a valid number.",this,a,c),e=!1;break}if(o!==null&&o>c){dt("KeyframeTrack: Out of order keys.",this,a,c,o),e=!1;break}o=c}if(s!==void 0&&iy(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){dt("KeyframeTrack: Value is not a valid number.",this,a,l),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===lc,r=e.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=e[a],u=e[a+1];if(l!==u&&(a!==1||l!==e[0]))if(s)c=!0;else{let d=a*n,h=d-n,f=d+n;for(let p=0;p!==n;++p){let _=t[d+p];if(_!==t[h+p]||_!==t[f+p]){c=!0;break}}}if(c){if(a!==o){e[o]=e[a];let d=a*n,h=o*n;for(let f=0;f!==n;++f)t[h+f]=t[d+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)t[c+l]=t[a+l];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,rc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Cg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Pg(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}Mi.prototype.ValueTypeName="";Mi.prototype.TimeBufferType=Float32Array;Mi.prototype.ValueBufferType=Float32Array;Mi.prototype.DefaultInterpolation=vc;var lr=class extends Mi{constructor(e,t,n){super(e,t,n)}};lr.prototype.ValueTypeName="bool";lr.prototype.ValueBufferType=Array;lr.prototype.DefaultInterpolation=Ea;lr.prototype.InterpolantFactoryMethodLinear=void 0;lr.prototype.InterpolantFactoryMethodSmooth=void 0;var Nc=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}};Nc.prototype.ValueTypeName="color";var Uc=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}};Uc.prototype.ValueTypeName="number";var Fc=class extends ar{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-t)/(s-t),l=e*a;for(let u=l+a;l!==u;l+=4)os.slerpFlat(r,0,o,l-a,o,l,c);return r}},Va=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new Fc(this.times,this.values,this.getValueSize(),e)}};Va.prototype.ValueTypeName="quaternion";Va.prototype.InterpolantFactoryMethodSmooth=void 0;var cr=class extends Mi{constructor(e,t,n){super(e,t,n)}};cr.prototype.ValueTypeName="string";cr.prototype.ValueBufferType=Array;cr.prototype.DefaultInterpolation=Ea;cr.prototype.InterpolantFactoryMethodLinear=void 0;cr.prototype.InterpolantFactoryMethodSmooth=void 0;var Oc=class extends Mi{constructor(e,t,n,s){super(e,t,n,s)}};Oc.prototype.ValueTypeName="vector";var Bc=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),c?c(u):u},this.setURLModifier=function(u){return c=u,this},this.addHandler=function(u,d){return l.push(u,d),this},this.removeHandler=function(u){let d=l.indexOf(u);return d!==-1&&l.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=l.length;d<h;d+=2){let f=l[d],p=l[d+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},M0=new Bc,kc=class{constructor(e){this.manager=e!==void 0?e:M0,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};kc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ha=class extends Wn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new yt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Wa=class extends Ha{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Wn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new yt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Ld=new ln,Ig=new ee,Lg=new ee,zc=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Tt(512,512),this.mapType=oi,this.map=null,this.mapPass=null,this.matrix=new ln,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new rr,this._frameExtents=new Tt(1,1),this._viewportCount=1,this._viewports=[new un(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Ig.setFromMatrixPosition(e.matrixWorld),t.position.copy(Ig),Lg.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Lg),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Ld.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Ld,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;e.coordinateSystem===Ro||e.reversedDepth?t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),t.multiply(Ld)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},oc=new ee,ac=new os,is=new ee,Xa=class extends Wn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ln,this.projectionMatrix=new ln,this.projectionMatrixInverse=new ln,this.coordinateSystem=Ci,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(oc,ac,is),is.x===1&&is.y===1&&is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oc,ac,is.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(oc,ac,is),is.x===1&&is.y===1&&is.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(oc,ac,is.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},tr=new ee,Dg=new Tt,Ng=new Tt,jn=class extends Xa{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=yc*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(hd*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return yc*2*Math.atan(Math.tan(hd*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){tr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(tr.x,tr.y).multiplyScalar(-e/tr.z),tr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(tr.x,tr.y).multiplyScalar(-e/tr.z)}getViewSize(e,t){return this.getViewBounds(e,Dg,Ng),t.subVectors(Ng,Dg)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(hd*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,t-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var qa=class extends Xa{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,c=s-t;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=u*this.view.offsetY,c=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Od=class extends zc{constructor(){super(new qa(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Ya=class extends Ha{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Wn.DEFAULT_UP),this.updateMatrix(),this.target=new Wn,this.shadow=new Od}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var wo=-90,To=1,Fo=class extends Wn{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new jn(wo,To,e,t);s.layers=this.layers,this.add(s);let r=new jn(wo,To,e,t);r.layers=this.layers,this.add(r);let o=new jn(wo,To,e,t);o.layers=this.layers,this.add(o);let a=new jn(wo,To,e,t);a.layers=this.layers,this.add(a);let c=new jn(wo,To,e,t);c.layers=this.layers,this.add(c);let l=new jn(wo,To,e,t);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,c]=t;for(let l of t)this.remove(l);if(e===Ci)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(e===Ro)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let l of t)this.add(l),l.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,u]=this.children,d=e.getRenderTarget(),h=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let _=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),e.setRenderTarget(n,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),n.texture.mipmapsAutoUpdate=_,e.setRenderTarget(n,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,h,f),e.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},Gc=class extends jn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var mf="\\[\\]\\.:\\/",Py=new RegExp("["+mf+"]","g"),gf="[^"+mf+"]",Iy="[^"+mf.replace("\\.","")+"]",Ly=/((?:WC+[\/:])*)/.source.replace("WC",gf),Dy=/(WCOD+)?/.source.replace("WCOD",Iy),Ny=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",gf),Uy=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",gf),Fy=new RegExp("^"+Ly+Dy+Ny+Uy+"$"),Oy=["material","materials","bones","map"],Bd=class{constructor(e,t,n){let s=n||sn.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},sn=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Py,"")}static parseTrackName(e){let t=Fy.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);Oy.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let c=n(a.children);if(c)return c}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){ct("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=t.objectIndex;switch(n){case"materials":if(!e.material){dt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){dt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){dt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===l){l=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){dt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){dt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){dt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(l!==void 0){if(e[l]===void 0){dt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[l]}}let o=e[s];if(o===void 0){let l=t.nodeName;dt("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){dt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){dt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};sn.Composite=Bd;sn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};sn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};sn.prototype.GetterByBindingType=[sn.prototype._getValue_direct,sn.prototype._getValue_array,sn.prototype._getValue_arrayElement,sn.prototype._getValue_toArray];sn.prototype.SetterByBindingTypeAndVersioning=[[sn.prototype._setValue_direct,sn.prototype._setValue_direct_setNeedsUpdate,sn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[sn.prototype._setValue_array,sn.prototype._setValue_array_setNeedsUpdate,sn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[sn.prototype._setValue_arrayElement,sn.prototype._setValue_arrayElement_setNeedsUpdate,sn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[sn.prototype._setValue_fromArray,sn.prototype._setValue_fromArray_setNeedsUpdate,sn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var LE=new Float32Array(1);var kd=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function xf(i,e,t,n){let s=By(n);switch(t){case rf:return i*e;case af:return i*e/s.components*s.byteLength;case Zc:return i*e/s.components*s.byteLength;case hr:return i*e*2/s.components*s.byteLength;case Jc:return i*e*2/s.components*s.byteLength;case of:return i*e*3/s.components*s.byteLength;case Xi:return i*e*4/s.components*s.byteLength;case Kc:return i*e*4/s.components*s.byteLength;case Ja:case Ka:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ja:case Qa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case Qc:case tu:return Math.max(i,16)*Math.max(e,8)/4;case jc:case eu:return Math.max(i,8)*Math.max(e,8)/2;case nu:case iu:case ru:case ou:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case su:case el:case au:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case lu:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case cu:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case uu:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case hu:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case du:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case fu:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case pu:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case mu:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case gu:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case xu:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case _u:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case vu:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case yu:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case bu:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case Mu:case Su:case wu:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Tu:case Eu:return Math.ceil(i/4)*Math.ceil(e/4)*8;case tl:case Au:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function By(i){switch(i){case oi:case ef:return{byteLength:1,components:1};case zo:case tf:case Wi:return{byteLength:2,components:1};case Yc:case $c:return{byteLength:2,components:4};case Vi:case qc:case Hi:return{byteLength:4,components:1};case nf:case sf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?ct("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function W0(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function Yy(i){let e=new WeakMap;function t(a,c){let l=a.array,u=a.usage,d=l.byteLength,h=i.createBuffer();i.bindBuffer(c,h),i.bufferData(c,l,u),a.onUploadCallback();let f;if(l instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=i.SHORT;else if(l instanceof Uint32Array)f=i.UNSIGNED_INT;else if(l instanceof Int32Array)f=i.INT;else if(l instanceof Int8Array)f=i.BYTE;else if(l instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:h,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:d}}function n(a,c,l){let u=c.array,d=c.updateRanges;if(i.bindBuffer(l,a),d.length===0)i.bufferSubData(l,0,u);else{d.sort((f,p)=>f.start-p.start);let h=0;for(let f=1;f<d.length;f++){let p=d[h],_=d[f];_.start<=p.start+p.count+1?p.count=Math.max(p.count,_.start+_.count-p.start):(++h,d[h]=_)}d.length=h+1;for(let f=0,p=d.length;f<p;f++){let _=d[f];i.bufferSubData(l,_.start*u.BYTES_PER_ELEMENT,u,_.start,_.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=e.get(a);c&&(i.deleteBuffer(c.buffer),e.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=e.get(a);if(l===void 0)e.set(a,t(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var $y=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Zy=`#ifdef USE_ALPHAHASH
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
#endif`,Jy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Ky=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,jy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Qy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,eb=`#ifdef USE_AOMAP
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
#endif`,tb=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,nb=`#ifdef USE_BATCHING
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
#endif`,ib=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,sb=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,rb=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ob=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,ab=`#ifdef USE_IRIDESCENCE
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
#endif`,lb=`#ifdef USE_BUMPMAP
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
#endif`,cb=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,ub=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,hb=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,db=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,fb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,pb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,mb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,gb=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,xb=`#define PI 3.141592653589793
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
} // validated`,_b=`vec3 transformedNormal = objectNormal;
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
#endif`,vb=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,yb=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,bb=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Mb=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Sb="gl_FragColor = linearToOutputTexel( gl_FragColor );",wb=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Tb=`#ifdef USE_ENVMAP
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
#endif`,Eb=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Ab=`#ifdef USE_ENVMAP
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
#endif`,Rb=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Cb=`#ifdef USE_ENVMAP
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
#endif`,Pb=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ib=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Lb=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Db=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Nb=`#ifdef USE_GRADIENTMAP
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
}`,Ub=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Fb=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Ob=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Bb=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,kb=`#ifdef USE_ENVMAP
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
#endif`,zb=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Gb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Vb=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Hb=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Wb=`PhysicalMaterial material;
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
#endif`,Xb=`uniform sampler2D dfgLUT;
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
}`,qb=`
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
#endif`,Yb=`#if defined( RE_IndirectDiffuse )
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
#endif`,$b=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Zb=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Jb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Kb=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,jb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Qb=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,eM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,tM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,nM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,iM=`#if defined( USE_POINTS_UV )
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
#endif`,sM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,rM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,oM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,aM=`#if defined( USE_MORPHCOLORS )
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
#endif`,lM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,cM=`#ifdef USE_MORPHTARGETS
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
#endif`,uM=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,hM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,dM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,fM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,pM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,mM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,gM=`#ifdef USE_NORMALMAP
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
#endif`,xM=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,_M=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,vM=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,yM=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,bM=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,MM=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,SM=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,wM=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,TM=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,EM=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,AM=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,RM=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,CM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,PM=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,IM=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,LM=`float getShadowMask() {
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
}`,DM=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,NM=`#ifdef USE_SKINNING
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
#endif`,UM=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,FM=`#ifdef USE_SKINNING
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
#endif`,OM=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,BM=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,kM=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,zM=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,GM=`#ifdef USE_TRANSMISSION
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
#endif`,VM=`#ifdef USE_TRANSMISSION
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
#endif`,HM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,WM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,XM=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,qM=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,YM=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,$M=`uniform sampler2D t2D;
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
}`,ZM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,JM=`uniform float backgroundBlurriness;
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
}`,KM=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jM=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,QM=`#include <common>
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
}`,eS=`#if DEPTH_PACKING == 3200
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
}`,tS=`#define DISTANCE
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
}`,nS=`#define DISTANCE
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
}`,iS=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,sS=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,rS=`uniform float scale;
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
}`,oS=`uniform vec3 diffuse;
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
}`,aS=`#include <common>
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
}`,lS=`uniform vec3 diffuse;
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
}`,cS=`#define LAMBERT
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
}`,uS=`#define LAMBERT
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
}`,hS=`#define MATCAP
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
}`,dS=`#define MATCAP
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
}`,fS=`#define NORMAL
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
}`,pS=`#define NORMAL
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
}`,mS=`#define PHONG
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
}`,gS=`#define PHONG
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
}`,xS=`#define STANDARD
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
}`,_S=`#define STANDARD
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
}`,vS=`#define TOON
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
}`,yS=`#define TOON
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
}`,bS=`uniform float size;
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
}`,MS=`uniform vec3 diffuse;
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
}`,SS=`#include <common>
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
}`,wS=`uniform vec3 color;
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
}`,TS=`uniform float rotation;
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
}`,ES=`uniform vec3 diffuse;
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
}`,vt={alphahash_fragment:$y,alphahash_pars_fragment:Zy,alphamap_fragment:Jy,alphamap_pars_fragment:Ky,alphatest_fragment:jy,alphatest_pars_fragment:Qy,aomap_fragment:eb,aomap_pars_fragment:tb,batching_pars_vertex:nb,batching_vertex:ib,begin_vertex:sb,beginnormal_vertex:rb,bsdfs:ob,iridescence_fragment:ab,bumpmap_pars_fragment:lb,clipping_planes_fragment:cb,clipping_planes_pars_fragment:ub,clipping_planes_pars_vertex:hb,clipping_planes_vertex:db,color_fragment:fb,color_pars_fragment:pb,color_pars_vertex:mb,color_vertex:gb,common:xb,defaultnormal_vertex:_b,displacementmap_pars_vertex:vb,displacementmap_vertex:yb,emissivemap_fragment:bb,emissivemap_pars_fragment:Mb,colorspace_fragment:Sb,colorspace_pars_fragment:wb,envmap_fragment:Tb,envmap_common_pars_fragment:Eb,envmap_pars_fragment:Ab,envmap_pars_vertex:Rb,envmap_physical_pars_fragment:kb,envmap_vertex:Cb,fog_vertex:Pb,fog_pars_vertex:Ib,fog_fragment:Lb,fog_pars_fragment:Db,gradientmap_pars_fragment:Nb,lightmap_pars_fragment:Ub,lights_lambert_fragment:Fb,lights_lambert_pars_fragment:Ob,lights_pars_begin:Bb,lights_toon_fragment:zb,lights_toon_pars_fragment:Gb,lights_phong_fragment:Vb,lights_phong_pars_fragment:Hb,lights_physical_fragment:Wb,lights_physical_pars_fragment:Xb,lights_fragment_begin:qb,lights_fragment_maps:Yb,lights_fragment_end:$b,lightprobes_pars_fragment:Zb,logdepthbuf_fragment:Jb,logdepthbuf_pars_fragment:Kb,logdepthbuf_pars_vertex:jb,logdepthbuf_vertex:Qb,map_fragment:eM,map_pars_fragment:tM,map_particle_fragment:nM,map_particle_pars_fragment:iM,metalnessmap_fragment:sM,metalnessmap_pars_fragment:rM,morphinstance_vertex:oM,morphcolor_vertex:aM,morphnormal_vertex:lM,morphtarget_pars_vertex:cM,morphtarget_vertex:uM,normal_fragment_begin:hM,normal_fragment_maps:dM,normal_pars_fragment:fM,normal_pars_vertex:pM,normal_vertex:mM,normalmap_pars_fragment:gM,clearcoat_normal_fragment_begin:xM,clearcoat_normal_fragment_maps:_M,clearcoat_pars_fragment:vM,iridescence_pars_fragment:yM,opaque_fragment:bM,packing:MM,premultiplied_alpha_fragment:SM,project_vertex:wM,dithering_fragment:TM,dithering_pars_fragment:EM,roughnessmap_fragment:AM,roughnessmap_pars_fragment:RM,shadowmap_pars_fragment:CM,shadowmap_pars_vertex:PM,shadowmap_vertex:IM,shadowmask_pars_fragment:LM,skinbase_vertex:DM,skinning_pars_vertex:NM,skinning_vertex:UM,skinnormal_vertex:FM,specularmap_fragment:OM,specularmap_pars_fragment:BM,tonemapping_fragment:kM,tonemapping_pars_fragment:zM,transmission_fragment:GM,transmission_pars_fragment:VM,uv_pars_fragment:HM,uv_pars_vertex:WM,uv_vertex:XM,worldpos_vertex:qM,background_vert:YM,background_frag:$M,backgroundCube_vert:ZM,backgroundCube_frag:JM,cube_vert:KM,cube_frag:jM,depth_vert:QM,depth_frag:eS,distance_vert:tS,distance_frag:nS,equirect_vert:iS,equirect_frag:sS,linedashed_vert:rS,linedashed_frag:oS,meshbasic_vert:aS,meshbasic_frag:lS,meshlambert_vert:cS,meshlambert_frag:uS,meshmatcap_vert:hS,meshmatcap_frag:dS,meshnormal_vert:fS,meshnormal_frag:pS,meshphong_vert:mS,meshphong_frag:gS,meshphysical_vert:xS,meshphysical_frag:_S,meshtoon_vert:vS,meshtoon_frag:yS,points_vert:bS,points_frag:MS,shadow_vert:SS,shadow_frag:wS,sprite_vert:TS,sprite_frag:ES},Be={common:{diffuse:{value:new yt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new pt},alphaMap:{value:null},alphaMapTransform:{value:new pt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new pt}},envmap:{envMap:{value:null},envMapRotation:{value:new pt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new pt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new pt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new pt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new pt},normalScale:{value:new Tt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new pt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new pt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new pt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new pt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new yt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new yt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new pt},alphaTest:{value:0},uvTransform:{value:new pt}},sprite:{diffuse:{value:new yt(16777215)},opacity:{value:1},center:{value:new Tt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new pt},alphaMap:{value:null},alphaMapTransform:{value:new pt},alphaTest:{value:0}}},hs={basic:{uniforms:Xn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.fog]),vertexShader:vt.meshbasic_vert,fragmentShader:vt.meshbasic_frag},lambert:{uniforms:Xn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new yt(0)},envMapIntensity:{value:1}}]),vertexShader:vt.meshlambert_vert,fragmentShader:vt.meshlambert_frag},phong:{uniforms:Xn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new yt(0)},specular:{value:new yt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:vt.meshphong_vert,fragmentShader:vt.meshphong_frag},standard:{uniforms:Xn([Be.common,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.roughnessmap,Be.metalnessmap,Be.fog,Be.lights,{emissive:{value:new yt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:vt.meshphysical_vert,fragmentShader:vt.meshphysical_frag},toon:{uniforms:Xn([Be.common,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.gradientmap,Be.fog,Be.lights,{emissive:{value:new yt(0)}}]),vertexShader:vt.meshtoon_vert,fragmentShader:vt.meshtoon_frag},matcap:{uniforms:Xn([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,{matcap:{value:null}}]),vertexShader:vt.meshmatcap_vert,fragmentShader:vt.meshmatcap_frag},points:{uniforms:Xn([Be.points,Be.fog]),vertexShader:vt.points_vert,fragmentShader:vt.points_frag},dashed:{uniforms:Xn([Be.common,Be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:vt.linedashed_vert,fragmentShader:vt.linedashed_frag},depth:{uniforms:Xn([Be.common,Be.displacementmap]),vertexShader:vt.depth_vert,fragmentShader:vt.depth_frag},normal:{uniforms:Xn([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,{opacity:{value:1}}]),vertexShader:vt.meshnormal_vert,fragmentShader:vt.meshnormal_frag},sprite:{uniforms:Xn([Be.sprite,Be.fog]),vertexShader:vt.sprite_vert,fragmentShader:vt.sprite_frag},background:{uniforms:{uvTransform:{value:new pt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:vt.background_vert,fragmentShader:vt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new pt}},vertexShader:vt.backgroundCube_vert,fragmentShader:vt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:vt.cube_vert,fragmentShader:vt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:vt.equirect_vert,fragmentShader:vt.equirect_frag},distance:{uniforms:Xn([Be.common,Be.displacementmap,{referencePosition:{value:new ee},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:vt.distance_vert,fragmentShader:vt.distance_frag},shadow:{uniforms:Xn([Be.lights,Be.fog,{color:{value:new yt(0)},opacity:{value:1}}]),vertexShader:vt.shadow_vert,fragmentShader:vt.shadow_frag}};hs.physical={uniforms:Xn([hs.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new pt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new pt},clearcoatNormalScale:{value:new Tt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new pt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new pt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new pt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new pt},sheen:{value:0},sheenColor:{value:new yt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new pt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new pt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new pt},transmissionSamplerSize:{value:new Tt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new pt},attenuationDistance:{value:0},attenuationColor:{value:new yt(0)},specularColor:{value:new yt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new pt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new pt},anisotropyVector:{value:new Tt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new pt}}]),vertexShader:vt.meshphysical_vert,fragmentShader:vt.meshphysical_frag};var Cu={r:0,b:0,g:0},AS=new ln,X0=new pt;X0.set(-1,0,0,0,1,0,0,0,1);function RS(i,e,t,n,s,r){let o=new yt(0),a=s===!0?0:1,c,l,u=null,d=0,h=null;function f(y){let A=y.isScene===!0?y.background:null;if(A&&A.isTexture){let S=y.backgroundBlurriness>0;A=e.get(A,S)}return A}function p(y){let A=!1,S=f(y);S===null?g(o,a):S&&S.isColor&&(g(S,1),A=!0);let P=i.xr.getEnvironmentBlendMode();P==="additive"?t.buffers.color.setClear(0,0,0,1,r):P==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||A)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function _(y,A){let S=f(A);S&&S.isCubeTexture?(l===void 0&&(l=new Bn(new or(1,1,1),new ls({name:"BackgroundCubeMaterial",uniforms:Fr(hs.backgroundCube.uniforms),vertexShader:hs.backgroundCube.vertexShader,fragmentShader:hs.backgroundCube.fragmentShader,side:ti,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(P,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=S,l.material.uniforms.backgroundBlurriness.value=A.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(AS.makeRotationFromEuler(A.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(X0),l.material.toneMapped=Rt.getTransfer(S.colorSpace)!==kt,(u!==S||d!==S.version||h!==i.toneMapping)&&(l.material.needsUpdate=!0,u=S,d=S.version,h=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null)):S&&S.isTexture&&(c===void 0&&(c=new Bn(new za(2,2),new ls({name:"BackgroundMaterial",uniforms:Fr(hs.background.uniforms),vertexShader:hs.background.vertexShader,fragmentShader:hs.background.fragmentShader,side:ur,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=S,c.material.uniforms.backgroundIntensity.value=A.backgroundIntensity,c.material.toneMapped=Rt.getTransfer(S.colorSpace)!==kt,S.matrixAutoUpdate===!0&&S.updateMatrix(),c.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||d!==S.version||h!==i.toneMapping)&&(c.material.needsUpdate=!0,u=S,d=S.version,h=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function g(y,A){y.getRGB(Cu,pf(i)),t.buffers.color.setClear(Cu.r,Cu.g,Cu.b,A,r)}function m(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,A=1){o.set(y),a=A,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,g(o,a)},render:p,addToRenderList:_,dispose:m}}function CS(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=h(null),r=s,o=!1;function a(L,z,H,D,G){let k=!1,U=d(L,D,H,z);r!==U&&(r=U,l(r.object)),k=f(L,D,H,G),k&&p(L,D,H,G),G!==null&&e.update(G,i.ELEMENT_ARRAY_BUFFER),(k||o)&&(o=!1,S(L,z,H,D),G!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(G).buffer))}function c(){return i.createVertexArray()}function l(L){return i.bindVertexArray(L)}function u(L){return i.deleteVertexArray(L)}function d(L,z,H,D){let G=D.wireframe===!0,k=n[z.id];k===void 0&&(k={},n[z.id]=k);let U=L.isInstancedMesh===!0?L.id:0,se=k[U];se===void 0&&(se={},k[U]=se);let X=se[H.id];X===void 0&&(X={},se[H.id]=X);let Y=X[G];return Y===void 0&&(Y=h(c()),X[G]=Y),Y}function h(L){let z=[],H=[],D=[];for(let G=0;G<t;G++)z[G]=0,H[G]=0,D[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:z,enabledAttributes:H,attributeDivisors:D,object:L,attributes:{},index:null}}function f(L,z,H,D){let G=r.attributes,k=z.attributes,U=0,se=H.getAttributes();for(let X in se)if(se[X].location>=0){let ie=G[X],ce=k[X];if(ce===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(ce=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(ce=L.instanceColor)),ie===void 0||ie.attribute!==ce||ce&&ie.data!==ce.data)return!0;U++}return r.attributesNum!==U||r.index!==D}function p(L,z,H,D){let G={},k=z.attributes,U=0,se=H.getAttributes();for(let X in se)if(se[X].location>=0){let ie=k[X];ie===void 0&&(X==="instanceMatrix"&&L.instanceMatrix&&(ie=L.instanceMatrix),X==="instanceColor"&&L.instanceColor&&(ie=L.instanceColor));let ce={};ce.attribute=ie,ie&&ie.data&&(ce.data=ie.data),G[X]=ce,U++}r.attributes=G,r.attributesNum=U,r.index=D}function _(){let L=r.newAttributes;for(let z=0,H=L.length;z<H;z++)L[z]=0}function g(L){m(L,0)}function m(L,z){let H=r.newAttributes,D=r.enabledAttributes,G=r.attributeDivisors;H[L]=1,D[L]===0&&(i.enableVertexAttribArray(L),D[L]=1),G[L]!==z&&(i.vertexAttribDivisor(L,z),G[L]=z)}function y(){let L=r.newAttributes,z=r.enabledAttributes;for(let H=0,D=z.length;H<D;H++)z[H]!==L[H]&&(i.disableVertexAttribArray(H),z[H]=0)}function A(L,z,H,D,G,k,U){U===!0?i.vertexAttribIPointer(L,z,H,G,k):i.vertexAttribPointer(L,z,H,D,G,k)}function S(L,z,H,D){_();let G=D.attributes,k=H.getAttributes(),U=z.defaultAttributeValues;for(let se in k){let X=k[se];if(X.location>=0){let Y=G[se];if(Y===void 0&&(se==="instanceMatrix"&&L.instanceMatrix&&(Y=L.instanceMatrix),se==="instanceColor"&&L.instanceColor&&(Y=L.instanceColor)),Y!==void 0){let ie=Y.normalized,ce=Y.itemSize,he=e.get(Y);if(he===void 0)continue;let Q=he.buffer,ge=he.type,_e=he.bytesPerElement,Te=ge===i.INT||ge===i.UNSIGNED_INT||Y.gpuType===qc;if(Y.isInterleavedBufferAttribute){let xe=Y.data,Ge=xe.isInterleavedBuffer===!0?xe.stride:xe.itemSize,qe=Y.offset;if(xe.isInstancedInterleavedBuffer||xe.isInstancedBufferAttribute){for(let ke=0;ke<X.locationSize;ke++)m(X.location+ke,xe.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=xe.meshPerAttribute*xe.count)}else for(let ke=0;ke<X.locationSize;ke++)g(X.location+ke);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let ke=0;ke<X.locationSize;ke++)A(X.location+ke,ce/X.locationSize,ge,ie,Ge*_e,(qe+ce/X.locationSize*ke)*_e,Te)}else{if(Y.isInstancedBufferAttribute){for(let xe=0;xe<X.locationSize;xe++)m(X.location+xe,Y.meshPerAttribute);L.isInstancedMesh!==!0&&D._maxInstanceCount===void 0&&(D._maxInstanceCount=Y.meshPerAttribute*Y.count)}else for(let xe=0;xe<X.locationSize;xe++)g(X.location+xe);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let xe=0;xe<X.locationSize;xe++)A(X.location+xe,ce/X.locationSize,ge,ie,ce*_e,ce/X.locationSize*xe*_e,Te)}}else if(U!==void 0){let ie=U[se];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(X.location,ie);break;case 3:i.vertexAttrib3fv(X.location,ie);break;case 4:i.vertexAttrib4fv(X.location,ie);break;default:i.vertexAttrib1fv(X.location,ie)}}}}y()}function P(){N();for(let L in n){let z=n[L];for(let H in z){let D=z[H];for(let G in D){let k=D[G];for(let U in k)u(k[U].object),delete k[U];delete D[G]}}delete n[L]}}function E(L){if(n[L.id]===void 0)return;let z=n[L.id];for(let H in z){let D=z[H];for(let G in D){let k=D[G];for(let U in k)u(k[U].object),delete k[U];delete D[G]}}delete n[L.id]}function x(L){for(let z in n){let H=n[z];for(let D in H){let G=H[D];if(G[L.id]===void 0)continue;let k=G[L.id];for(let U in k)u(k[U].object),delete k[U];delete G[L.id]}}}function b(L){for(let z in n){let H=n[z],D=L.isInstancedMesh===!0?L.id:0,G=H[D];if(G!==void 0){for(let k in G){let U=G[k];for(let se in U)u(U[se].object),delete U[se];delete G[k]}delete H[D],Object.keys(H).length===0&&delete n[z]}}}function N(){R(),o=!0,r!==s&&(r=s,l(r.object))}function R(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:N,resetDefaultState:R,dispose:P,releaseStatesOfGeometry:E,releaseStatesOfObject:b,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:g,disableUnusedAttributes:y}}function PS(i,e,t){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),t.update(l,n,1)}function o(c,l,u){u!==0&&(i.drawArraysInstanced(n,c,l,u),t.update(l,n,u))}function a(c,l,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,u);let h=0;for(let f=0;f<u;f++)h+=l[f];t.update(h,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function IS(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Xi&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let b=x===Wi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==oi&&x!==Hi&&!b&&n.convert(x)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(x){if(x==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=t.precision!==void 0?t.precision:"highp",u=c(l);u!==l&&(ct("WebGLRenderer:",l,"not supported, using",u,"instead."),l=u);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&ct("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&ct("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_TEXTURE_SIZE),g=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),m=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),A=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),P=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:_,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:y,maxVaryings:A,maxFragmentUniforms:S,maxSamples:P,samples:E}}function LS(i){let e=this,t=null,n=0,s=!1,r=!1,o=new Gi,a=new pt,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let f=d.length!==0||h||n!==0||s;return s=h,n=d.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){t=u(d,h,0)},this.setState=function(d,h,f){let p=d.clippingPlanes,_=d.clipIntersection,g=d.clipShadows,m=i.get(d);if(!s||p===null||p.length===0||r&&!g)r?u(null):l();else{let y=r?0:n,A=y*4,S=m.clippingState||null;c.value=S,S=u(p,h,A,f);for(let P=0;P!==A;++P)S[P]=t[P];m.clippingState=S,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=y}};function l(){c.value!==t&&(c.value=t,c.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(d,h,f,p){let _=d!==null?d.length:0,g=null;if(_!==0){if(g=c.value,p!==!0||g===null){let m=f+_*4,y=h.matrixWorldInverse;a.getNormalMatrix(y),(g===null||g.length<m)&&(g=new Float32Array(m));for(let A=0,S=f;A!==_;++A,S+=4)o.copy(d[A]).applyMatrix4(y,a),o.normal.toArray(g,S),g[S+3]=o.constant}c.value=g,c.needsUpdate=!0}return e.numPlanes=_,e.numIntersection=0,g}}var rl=class extends yi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Ua(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new or(5,5,5),r=new ls({name:"CubemapFromEquirect",uniforms:Fr(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:ti,blending:Lr});r.uniforms.tEquirect.value=t;let o=new Bn(s,r),a=t.minFilter;return t.minFilter===Is&&(t.minFilter=Qn),new Fo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},S0=256,DS=3,NS=20,q0=256,Y0=16,US=3,FS=new ee,OS=new yt,Iu=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Fo(1,10,null),this._boxMesh=new Bn(new or(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=FS}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let d=c.autoClear,h=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,_=e.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,_===null&&(e.background=c.getClearColor(OS));let g=new Fo(n,s,u);return g.position.copy(a),g.update(c,e),c.autoClear=d,c.autoClearColor=h,c.autoClearDepth=f,c.autoClearStencil=p,e.background=_,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(l,t)),this._applyPMREM(l),l}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=E0(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=T0(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(S0,_0(e))}_fromTexture(e,t){e.mapping===Nr||e.mapping===ko?this._setSize(e.image.length===0?S0:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=w0(e,!1,!1),n=Math.log2(e)-DS;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=w0(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Nr||e.mapping===ko?(this._cubemapMaterial===null&&(this._cubemapMaterial=E0()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=T0()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=BS(),this._integrationMaterial=kS());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Y0);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-US)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let c=a>0?Math.log2(t)+.5*Math.log2(6/(q0*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=zS());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function w0(i,e,t){return new rl(i,{minFilter:Is,generateMipmaps:e,type:Wi,colorSpace:Aa,depthBuffer:t})}function ol(i,e,t){return new ls({name:i,uniforms:e,vertexShader:vt.cube_vert,fragmentShader:t,side:ti,blending:Lr,depthTest:!1,depthWrite:!1})}function BS(){return ol("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${q0}u

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
	`)}function kS(){return ol("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Y0}},`

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
	`)}function zS(){return ol("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${NS}
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
	`)}function T0(){return ol("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function E0(){return ol("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function GS(i){let e=new WeakMap,t=new WeakMap,n=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===Hc||f===Wc)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let _=new rl(p.height);return _.fromEquirectangularTexture(i,h),e.set(h,_),h.addEventListener("dispose",l),a(_.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.mapping,p=f===Hc||f===Wc,_=f===Nr||f===ko;if(p||_){let g=t.get(h),m=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return n===null&&(n=new Iu(i)),g=p?n.fromEquirectangular(h,g):n.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let y=h.image;return p&&y&&y.height>0||_&&y&&c(y)?(n===null&&(n=new Iu(i)),g=p?n.fromEquirectangular(h):n.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,f){return f===Hc?h.mapping=Nr:f===Wc&&(h.mapping=ko),h}function c(h){let f=0,p=6;for(let _=0;_<p;_++)h[_]!==void 0&&f++;return f===p}function l(h){let f=h.target;f.removeEventListener("dispose",l);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(h){let f=h.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function d(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:d}}function VS(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Ta("WebGLRenderer: "+n+" extension not supported."),s}}}function HS(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let _=r.get(p);_&&(e.remove(_),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function l(p,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),t.memory.geometries++),_}function u(p){let _=p.attributes;for(let g in _)e.update(_[g],i.ARRAY_BUFFER)}function d(p){let _=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let y=_!==null?_.array.length:g.array.length/3-1,A=g.count>=65535?Na:Da,S=new A(Math.ceil(y/3)*6,1),P=S.array;if(_!==null){let x=_.array;m=_.version;for(let b=0,N=0;b<y;b+=3){let R=x[b+0],L=x[b+1],z=x[b+2];P[N++]=R,P[N++]=L,P[N++]=L,P[N++]=z,P[N++]=z,P[N++]=R}}else{m=g.version;for(let x=0,b=0;x<y;x+=3){let N=x+0,R=x+1,L=x+2;P[b++]=N,P[b++]=R,P[b++]=R,P[b++]=L,P[b++]=L,P[b++]=N}}S.version=m;let E=r.get(p);E&&e.remove(E),r.set(p,S)}function h(p){let _=r.get(p);if(_){let g=p.index;g!==null&&_.version<g.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let _=s[p].deref();_!==void 0&&c(_)}}return{get:l,update:u,getWireframeAttribute:h,dispose:f}}function WS(i,e,t){let n;function s(d){n=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function c(d,h){i.drawElements(n,h,r,d*o),t.update(h,n,1)}function l(d,h,f){f!==0&&(i.drawElementsInstanced(n,h,r,d*o,f),t.update(h,n,f))}function u(d,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,h,0,r,d,0,f);let _=0;for(let g=0;g<f;g++)_+=h[g];t.update(_,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=u}function XS(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:dt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function qS(i,e,t){let n=new WeakMap,s=new un;function r(o,a,c){let l=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=n.get(a);if(h===void 0||h.count!==d){let N=function(){x.dispose(),n.delete(a),a.removeEventListener("dispose",N)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],A=0;f===!0&&(A=1),p===!0&&(A=2),_===!0&&(A=3);let S=a.attributes.position.count*A,P=1;S>e.maxTextureSize&&(P=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let E=new Float32Array(S*P*4*d),x=new Pa(E,S,P,d);x.type=Hi,x.needsUpdate=!0;let b=A*4;for(let R=0;R<d;R++){let L=g[R],z=m[R],H=y[R],D=S*P*4*R;for(let G=0;G<L.count;G++){let k=G*b;f===!0&&(s.fromBufferAttribute(L,G),E[D+k+0]=s.x,E[D+k+1]=s.y,E[D+k+2]=s.z,E[D+k+3]=0),p===!0&&(s.fromBufferAttribute(z,G),E[D+k+4]=s.x,E[D+k+5]=s.y,E[D+k+6]=s.z,E[D+k+7]=0),_===!0&&(s.fromBufferAttribute(H,G),E[D+k+8]=s.x,E[D+k+9]=s.y,E[D+k+10]=s.z,E[D+k+11]=H.itemSize===4?s.w:1)}}h={count:d,texture:x,size:new Tt(S,P)},n.set(a,h),a.addEventListener("dispose",N)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let _=0;_<l.length;_++)f+=l[_];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(i,"morphTargetBaseInfluence",p),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",h.texture,t),c.getUniforms().setValue(i,"morphTargetsTextureSize",h.size)}return{update:r}}function YS(i,e,t,n,s){let r=new WeakMap;function o(l){let u=s.render.frame,d=l.geometry,h=e.get(l,d);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==u&&(t.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&t.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,u))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return h}function a(){r=new WeakMap}function c(l){let u=l.target;u.removeEventListener("dispose",c),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var $S={[qd]:"LINEAR_TONE_MAPPING",[Yd]:"REINHARD_TONE_MAPPING",[$d]:"CINEON_TONE_MAPPING",[Zd]:"ACES_FILMIC_TONE_MAPPING",[Kd]:"AGX_TONE_MAPPING",[jd]:"NEUTRAL_TONE_MAPPING",[Jd]:"CUSTOM_TONE_MAPPING"};function ZS(i,e,t,n,s,r){let o=new yi(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,u=new bi;u.setAttribute("position",new cn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new cn([0,2,0,0,2,0],2));let d=new Ac({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new Bn(u,d),f=new qa(-1,1,1,-1,0,1),p=null,_=null,g=!1,m,y=null,A=[],S=!1;this.setSize=function(P,E){o.setSize(P,E),a!==null&&a.setSize(P,E),c!==null&&c.setSize(P,E);for(let x=0;x<A.length;x++){let b=A[x];b.setSize&&b.setSize(P,E)}},this.setEffects=function(P){A=P,S=A.length>0&&A[0].isRenderPass===!0;let E=o.width,x=o.height;A.length>0&&a===null&&(a=new yi(E,x,{type:Wi,depthBuffer:!1,stencilBuffer:!1}),c=new yi(E,x,{type:Wi,depthBuffer:!1,stencilBuffer:!1}));let b=s===!0&&A.some(N=>N.needsDepthTexture===!0);b!==(o.depthTexture!==null)&&(b===!0&&l===null&&(l=new Ps(E,x),r===!0&&(l.format=Ls,l.type=Ur)),o.dispose(),o.depthTexture=b?l:null,o.resolveDepthBuffer=b,o.storeMultisampledDepthBuffer=b);for(let N=0;N<A.length;N++){let R=A[N];R.setSize&&R.setSize(E,x),b&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(l)}},this.begin=function(P,E){if(g||P.toneMapping===cs&&A.length===0)return!1;if(y=E,E!==null){let x=E.width,b=E.height;(o.width!==x||o.height!==b)&&this.setSize(x,b)}return S===!1&&P.setRenderTarget(o),m=P.toneMapping,P.toneMapping=cs,!0},this.hasRenderPass=function(){return S},this.end=function(P,E){P.toneMapping=m,g=!0;let x=o,b=a;for(let N=0;N<A.length;N++){let R=A[N];R.enabled!==!1&&(R.render(P,b,x,E),R.needsSwap!==!1&&(x=b,b=b===a?c:a))}if(p!==P.outputColorSpace||_!==P.toneMapping){p=P.outputColorSpace,_=P.toneMapping,d.defines={},Rt.getTransfer(p)===kt&&(d.defines.SRGB_TRANSFER="");let N=$S[_];N&&(d.defines[N]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=x.texture,P.setRenderTarget(y),P.render(h,f),y=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),u.dispose(),d.dispose()}}var $0=new ei,Z0=new Ps(1,1),J0=new Oa(1),K0=new Pa,j0=new Sc,Q0=new Ua,A0=[],R0=[],C0=new Float32Array(16),P0=new Float32Array(9),I0=new Float32Array(4);function Vo(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=A0[s];if(r===void 0&&(r=new Float32Array(s),A0[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function En(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function An(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Du(i,e){let t=R0[e];t===void 0&&(t=new Int32Array(e),R0[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function JS(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function KS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2fv(this.addr,e),An(t,e)}}function jS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(En(t,e))return;i.uniform3fv(this.addr,e),An(t,e)}}function QS(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4fv(this.addr,e),An(t,e)}}function ew(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),An(t,e)}else{if(En(t,n))return;I0.set(n),i.uniformMatrix2fv(this.addr,!1,I0),An(t,n)}}function tw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),An(t,e)}else{if(En(t,n))return;P0.set(n),i.uniformMatrix3fv(this.addr,!1,P0),An(t,n)}}function nw(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(En(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),An(t,e)}else{if(En(t,n))return;C0.set(n),i.uniformMatrix4fv(this.addr,!1,C0),An(t,n)}}function iw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function sw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2iv(this.addr,e),An(t,e)}}function rw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(En(t,e))return;i.uniform3iv(this.addr,e),An(t,e)}}function ow(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4iv(this.addr,e),An(t,e)}}function aw(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function lw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(En(t,e))return;i.uniform2uiv(this.addr,e),An(t,e)}}function cw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(En(t,e))return;i.uniform3uiv(this.addr,e),An(t,e)}}function uw(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(En(t,e))return;i.uniform4uiv(this.addr,e),An(t,e)}}function Nu(i){return i.version===0&&(i.compareFunction=uf,i.needsUpdate=!0),i}function hw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Nu(Z0):r=$0,t.setTexture2D(e||r,s)}function dw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||j0,s)}function fw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Nu(J0):r=Q0,t.setTextureCube(e||r,s)}function pw(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||K0,s)}function mw(i){switch(i){case 5126:return JS;case 35664:return KS;case 35665:return jS;case 35666:return QS;case 35674:return ew;case 35675:return tw;case 35676:return nw;case 5124:case 35670:return iw;case 35667:case 35671:return sw;case 35668:case 35672:return rw;case 35669:case 35673:return ow;case 5125:return aw;case 36294:return lw;case 36295:return cw;case 36296:return uw;case 35678:case 36198:case 36298:case 36306:case 35682:return hw;case 35679:case 36299:case 36307:return dw;case 35680:case 36300:case 36308:case 36293:return fw;case 36289:case 36303:case 36311:case 36292:return pw}}function gw(i,e){i.uniform1fv(this.addr,e)}function xw(i,e){let t=Vo(e,this.size,2);i.uniform2fv(this.addr,t)}function _w(i,e){let t=Vo(e,this.size,3);i.uniform3fv(this.addr,t)}function vw(i,e){let t=Vo(e,this.size,4);i.uniform4fv(this.addr,t)}function yw(i,e){let t=Vo(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function bw(i,e){let t=Vo(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function Mw(i,e){let t=Vo(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Sw(i,e){i.uniform1iv(this.addr,e)}function ww(i,e){i.uniform2iv(this.addr,e)}function Tw(i,e){i.uniform3iv(this.addr,e)}function Ew(i,e){i.uniform4iv(this.addr,e)}function Aw(i,e){i.uniform1uiv(this.addr,e)}function Rw(i,e){i.uniform2uiv(this.addr,e)}function Cw(i,e){i.uniform3uiv(this.addr,e)}function Pw(i,e){i.uniform4uiv(this.addr,e)}function Iw(i,e,t){let n=this.cache,s=e.length,r=Du(t,s);En(n,r)||(i.uniform1iv(this.addr,r),An(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Nu(Z0):o=$0;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Lw(i,e,t){let n=this.cache,s=e.length,r=Du(t,s);En(n,r)||(i.uniform1iv(this.addr,r),An(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||j0,r[o])}function Dw(i,e,t){let n=this.cache,s=e.length,r=Du(t,s);En(n,r)||(i.uniform1iv(this.addr,r),An(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Nu(J0):o=Q0;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function Nw(i,e,t){let n=this.cache,s=e.length,r=Du(t,s);En(n,r)||(i.uniform1iv(this.addr,r),An(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||K0,r[o])}function Uw(i){switch(i){case 5126:return gw;case 35664:return xw;case 35665:return _w;case 35666:return vw;case 35674:return yw;case 35675:return bw;case 35676:return Mw;case 5124:case 35670:return Sw;case 35667:case 35671:return ww;case 35668:case 35672:return Tw;case 35669:case 35673:return Ew;case 5125:return Aw;case 36294:return Rw;case 36295:return Cw;case 36296:return Pw;case 35678:case 36198:case 36298:case 36306:case 35682:return Iw;case 35679:case 36299:case 36307:return Lw;case 35680:case 36300:case 36308:case 36293:return Dw;case 36289:case 36303:case 36311:case 36292:return Nw}}var yf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=mw(t.type)}},bf=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Uw(t.type)}},Mf=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},_f=/(\w+)(\])?(\[|\.)?/g;function L0(i,e){i.seq.push(e),i.map[e.id]=e}function Fw(i,e,t){let n=i.name,s=n.length;for(_f.lastIndex=0;;){let r=_f.exec(n),o=_f.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){L0(t,l===void 0?new yf(a,i,e):new bf(a,i,e));break}else{let d=t.map[a];d===void 0&&(d=new Mf(a),L0(t,d)),t=d}}}var Go=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),c=e.getUniformLocation(t,a.name);Fw(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(e,c.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function D0(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var Ow=37297,Bw=0;function kw(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var N0=new pt;function zw(i){Rt._getMatrix(N0,Rt.workingColorSpace,i);let e=`mat3( ${N0.elements.map(t=>t.toFixed(4))} )`;switch(Rt.getTransfer(i)){case Ra:return[e,"LinearTransferOETF"];case kt:return[e,"sRGBTransferOETF"];default:return ct("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function U0(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+kw(i.getShaderSource(e),a)}else return r}function Gw(i,e){let t=zw(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Vw={[qd]:"Linear",[Yd]:"Reinhard",[$d]:"Cineon",[Zd]:"ACESFilmic",[Kd]:"AgX",[jd]:"Neutral",[Jd]:"Custom"};function Hw(i,e){let t=Vw[e];return t===void 0?(ct("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Pu=new ee;function Ww(){Rt.getLuminanceCoefficients(Pu);let i=Pu.x.toFixed(4),e=Pu.y.toFixed(4),t=Pu.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Xw(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(sl).join(`
`)}function qw(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function Yw(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function sl(i){return i!==""}function F0(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function O0(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var $w=/^[ \t]*#include +<([\w\d./]+)>/gm;function Sf(i){return i.replace($w,Zw)}function Zw(i,e){let t=vt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Sf(t)}var Jw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function B0(i){return i.replace(Jw,Kw)}function Kw(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function k0(i){let e=`precision ${i.precision} float;
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
#define LOW_PRECISION`),e}var jw={[$a]:"SHADOWMAP_TYPE_PCF",[Oo]:"SHADOWMAP_TYPE_VSM"};function Qw(i){return jw[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var e1={[ko]:"ENVMAP_MODE_REFRACTION"};function t1(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":e1[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var n1={[Vc]:"ENVMAP_BLENDING_MULTIPLY",[n0]:"ENVMAP_BLENDING_MIX",[i0]:"ENVMAP_BLENDING_ADD"};function i1(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":n1[i.combine]||"ENVMAP_BLENDING_NONE"}function s1(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,c=Qw(t),l=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=t1(t),d=i1(t),h=Xw(t),f=qw(r),p=s.createProgram(),_,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(_=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(sl).join(`
`),_.length>0&&(_+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(sl).join(`
`),g.length>0&&(g+=`
`)):(_=[k0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(sl).join(`
`),g=[k0(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+l:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+c:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==cs?"#define TONE_MAPPING":"",t.toneMapping!==cs?vt.tonemapping_pars_fragment:"",t.toneMapping!==cs?Hw("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",vt.colorspace_pars_fragment,Gw("linearToOutputTexel",t.outputColorSpace),Ww(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(sl).join(`
`)),o=Sf(o),o=F0(o,t),o=O0(o,t),a=Sf(a),a=F0(a,t),a=O0(a,t),o=B0(o),a=B0(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,_=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,g=["#define varying in",t.glslVersion===hf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===hf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let y=m+_+o,A=m+g+a,S=D0(s,s.VERTEX_SHADER,y),P=D0(s,s.FRAGMENT_SHADER,A);s.attachShader(p,S),s.attachShader(p,P),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(R){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",z=s.getShaderInfoLog(S)||"",H=s.getShaderInfoLog(P)||"",D=L.trim(),G=z.trim(),k=H.trim(),U=!0,se=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(U=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,S,P);else{let X=U0(s,S,"vertex"),Y=U0(s,P,"fragment");dt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+D+`
`+X+`
`+Y)}else D!==""?ct("WebGLProgram: Program Info Log:",D):(G===""||k==="")&&(se=!1);se&&(R.diagnostics={runnable:U,programLog:D,vertexShader:{log:G,prefix:_},fragmentShader:{log:k,prefix:g}})}s.deleteShader(S),s.deleteShader(P),x=new Go(s,p),b=Yw(s,p)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let b;this.getAttributes=function(){return b===void 0&&E(this),b};let N=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=s.getProgramParameter(p,Ow)),N},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Bw++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=P,this}var r1=0,wf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Tf(e),t.set(e,n)),n}},Tf=class{constructor(e){this.id=r1++,this.code=e,this.usedTimes=0}};function o1(i){return i===hr||i===el||i===tl}function a1(i,e,t,n,s,r){let o=new Ia,a=new wf,c=new Set,l=[],u=new Map,d=n.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return c.add(x),x===0?"uv":`uv${x}`}function p(x,b,N,R,L,z){let H=R.fog,D=L.geometry,G=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?R.environment:null,k=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,U=e.get(x.envMap||G,k),se=h[x.type],X=n.precision;x.precision!==null&&(X=n.getMaxPrecision(x.precision),X!==x.precision&&ct("WebGLProgram.getParameters:",x.precision,"not supported, using",X,"instead."));let Y=D.morphAttributes.position||D.morphAttributes.normal||D.morphAttributes.color,ie=Y!==void 0?Y.length:0,ce=0;D.morphAttributes.position!==void 0&&(ce=1),D.morphAttributes.normal!==void 0&&(ce=2),D.morphAttributes.color!==void 0&&(ce=3);let he,Q,ge,_e;if(se){let Pe=hs[se];he=Pe.vertexShader,Q=Pe.fragmentShader}else{he=x.vertexShader,Q=x.fragmentShader;let Pe=a.getVertexShaderStage(x),mt=a.getFragmentShaderStage(x);a.update(x,Pe,mt),ge=Pe.id,_e=mt.id}let Te=i.getRenderTarget(),xe=i.state.buffers.depth.getReversed(),Ge=L.isInstancedMesh===!0,qe=L.isBatchedMesh===!0,ke=!!x.map,it=!!x.matcap,ot=!!U,rt=ot&&U.isPMREMTexture===!0,ve=!!x.aoMap,me=!!x.lightMap,Fe=!!x.bumpMap&&x.wireframe===!1,We=!!x.normalMap,at=!!x.displacementMap,ut=!!x.emissiveMap,Kt=!!x.metalnessMap,Yt=!!x.roughnessMap,zt=x.anisotropy>0,O=x.clearcoat>0,De=x.diffuseRoughness>0,tt=x.dispersion>0,ft=x.retroreflectivity>0,Ce=x.iridescence>0,Pt=x.sheen>0,Ye=x.transmission>0,et=zt&&!!x.anisotropyMap,C=O&&!!x.clearcoatMap,M=O&&!!x.clearcoatNormalMap,q=O&&!!x.clearcoatRoughnessMap,fe=De&&!!x.diffuseRoughnessMap,le=Ce&&!!x.iridescenceMap,Se=Ce&&!!x.iridescenceThicknessMap,we=Pt&&!!x.sheenColorMap,te=Pt&&!!x.sheenRoughnessMap,oe=!!x.specularMap,ye=!!x.specularColorMap,B=!!x.specularIntensityMap,ae=Ye&&!!x.transmissionMap,re=Ye&&!!x.thicknessMap,Ae=!!x.gradientMap,Me=!!x.alphaMap,Ee=x.alphaTest>0,je=!!x.alphaHash,st=!!x.extensions,de=cs;x.toneMapped&&(Te===null||Te.isXRRenderTarget===!0)&&(de=i.toneMapping);let He=rt?U.isCompressedCubeTexture?U.image[0].mipmaps:U.mipmaps:null,nt={shaderID:se,shaderType:x.type,shaderName:x.name,vertexShader:he,fragmentShader:Q,defines:x.defines,customVertexShaderID:ge,customFragmentShaderID:_e,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:X,batching:qe,batchingColor:qe&&L._colorsTexture!==null,instancing:Ge,instancingColor:Ge&&L.instanceColor!==null,instancingMorph:Ge&&L.morphTexture!==null,outputColorSpace:Te===null?i.outputColorSpace:Te.isXRRenderTarget===!0?Te.texture.colorSpace:Rt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:ke,matcap:it,envMap:ot,envMapMode:ot&&U.mapping,envMapPMREM:rt,envMapMaxLod:rt?He.length-1:null,envMapSize:rt?He[0].width:null,aoMap:ve,lightMap:me,bumpMap:Fe,normalMap:We,displacementMap:at,emissiveMap:ut,normalMapObjectSpace:We&&x.normalMapType===o0,normalMapTangentSpace:We&&x.normalMapType===Ru,packedNormalMap:We&&x.normalMapType===Ru&&o1(x.normalMap.format),metalnessMap:Kt,roughnessMap:Yt,anisotropy:zt,anisotropyMap:et,clearcoat:O,clearcoatMap:C,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:De,diffuseRoughnessMap:fe,dispersion:tt,retroreflection:ft,iridescence:Ce,iridescenceMap:le,iridescenceThicknessMap:Se,sheen:Pt,sheenColorMap:we,sheenRoughnessMap:te,specularMap:oe,specularColorMap:ye,specularIntensityMap:B,transmission:Ye,transmissionMap:ae,thicknessMap:re,gradientMap:Ae,opaque:x.transparent===!1&&x.blending===Bo&&x.alphaToCoverage===!1,alphaMap:Me,alphaTest:Ee,alphaHash:je,combine:x.combine,mapUv:ke&&f(x.map.channel),aoMapUv:ve&&f(x.aoMap.channel),lightMapUv:me&&f(x.lightMap.channel),bumpMapUv:Fe&&f(x.bumpMap.channel),normalMapUv:We&&f(x.normalMap.channel),displacementMapUv:at&&f(x.displacementMap.channel),emissiveMapUv:ut&&f(x.emissiveMap.channel),metalnessMapUv:Kt&&f(x.metalnessMap.channel),roughnessMapUv:Yt&&f(x.roughnessMap.channel),anisotropyMapUv:et&&f(x.anisotropyMap.channel),clearcoatMapUv:C&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:fe&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:le&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:Se&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:we&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(x.sheenRoughnessMap.channel),specularMapUv:oe&&f(x.specularMap.channel),specularColorMapUv:ye&&f(x.specularColorMap.channel),specularIntensityMapUv:B&&f(x.specularIntensityMap.channel),transmissionMapUv:ae&&f(x.transmissionMap.channel),thicknessMapUv:re&&f(x.thicknessMap.channel),alphaMapUv:Me&&f(x.alphaMap.channel),vertexTangents:!!D.attributes.tangent&&(We||zt),vertexNormals:!!D.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!D.attributes.color&&D.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!D.attributes.uv&&(ke||Me),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||D.attributes.normal===void 0&&We===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:xe,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:D.attributes.position!==void 0,morphTargets:D.morphAttributes.position!==void 0,morphNormals:D.morphAttributes.normal!==void 0,morphColors:D.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:ce,numSunLights:b.sun.length,numDirLights:b.directional.length,numPointLights:b.point.length,numSpotLights:b.spot.length,numSpotLightMaps:b.spotLightMap.length,numRectAreaLights:b.rectArea.length,numHemiLights:b.hemi.length,numSunLightShadows:b.sunShadowMap.length,numDirLightShadows:b.directionalShadowMap.length,numPointLightShadows:b.pointShadowMap.length,numSpotLightShadows:b.spotShadowMap.length,numSpotLightShadowsWithMaps:b.numSpotLightShadowsWithMaps,numLightProbes:b.numLightProbes,numLightProbeGrids:z.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:i.shadowMap.enabled&&N.length>0,shadowMapType:i.shadowMap.type,toneMapping:de,decodeVideoTexture:ke&&x.map.isVideoTexture===!0&&Rt.getTransfer(x.map.colorSpace)===kt,decodeVideoTextureEmissive:ut&&x.emissiveMap.isVideoTexture===!0&&Rt.getTransfer(x.emissiveMap.colorSpace)===kt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Ii,flipSided:x.side===ti,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:st&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(st&&x.extensions.multiDraw===!0||qe)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return nt.vertexUv1s=c.has(1),nt.vertexUv2s=c.has(2),nt.vertexUv3s=c.has(3),c.clear(),nt}function _(x){let b=[];if(x.shaderID?b.push(x.shaderID):(b.push(x.customVertexShaderID),b.push(x.customFragmentShaderID)),x.defines!==void 0)for(let N in x.defines)b.push(N),b.push(x.defines[N]);return x.isRawShaderMaterial===!1&&(g(b,x),m(b,x),b.push(i.outputColorSpace)),b.push(x.customProgramCacheKey),b.join()}function g(x,b){x.push(b.precision),x.push(b.outputColorSpace),x.push(b.envMapMode),x.push(b.envMapPMREM),x.push(b.envMapMaxLod),x.push(b.envMapSize),x.push(b.mapUv),x.push(b.alphaMapUv),x.push(b.lightMapUv),x.push(b.aoMapUv),x.push(b.bumpMapUv),x.push(b.normalMapUv),x.push(b.displacementMapUv),x.push(b.emissiveMapUv),x.push(b.metalnessMapUv),x.push(b.roughnessMapUv),x.push(b.anisotropyMapUv),x.push(b.clearcoatMapUv),x.push(b.clearcoatNormalMapUv),x.push(b.clearcoatRoughnessMapUv),x.push(b.diffuseRoughnessMapUv),x.push(b.iridescenceMapUv),x.push(b.iridescenceThicknessMapUv),x.push(b.sheenColorMapUv),x.push(b.sheenRoughnessMapUv),x.push(b.specularMapUv),x.push(b.specularColorMapUv),x.push(b.specularIntensityMapUv),x.push(b.transmissionMapUv),x.push(b.thicknessMapUv),x.push(b.combine),x.push(b.fogExp2),x.push(b.sizeAttenuation),x.push(b.morphTargetsCount),x.push(b.numSunLights),x.push(b.numDirLights),x.push(b.numPointLights),x.push(b.numSpotLights),x.push(b.numSpotLightMaps),x.push(b.numHemiLights),x.push(b.numRectAreaLights),x.push(b.numSunLightShadows),x.push(b.numDirLightShadows),x.push(b.numPointLightShadows),x.push(b.numSpotLightShadows),x.push(b.numSpotLightShadowsWithMaps),x.push(b.numLightProbes),x.push(b.numLightProbeGrids),x.push(b.shadowMapType),x.push(b.toneMapping),x.push(b.numClippingPlanes),x.push(b.numClipIntersection),x.push(b.depthPacking)}function m(x,b){o.disableAll(),b.instancing&&o.enable(0),b.instancingColor&&o.enable(1),b.instancingMorph&&o.enable(2),b.matcap&&o.enable(3),b.envMap&&o.enable(4),b.normalMapObjectSpace&&o.enable(5),b.normalMapTangentSpace&&o.enable(6),b.clearcoat&&o.enable(7),b.iridescence&&o.enable(8),b.alphaTest&&o.enable(9),b.vertexColors&&o.enable(10),b.vertexAlphas&&o.enable(11),b.vertexUv1s&&o.enable(12),b.vertexUv2s&&o.enable(13),b.vertexUv3s&&o.enable(14),b.vertexTangents&&o.enable(15),b.anisotropy&&o.enable(16),b.alphaHash&&o.enable(17),b.batching&&o.enable(18),b.dispersion&&o.enable(19),b.retroreflection&&o.enable(24),b.diffuseRoughness&&o.enable(25),b.batchingColor&&o.enable(20),b.gradientMap&&o.enable(21),b.packedNormalMap&&o.enable(22),b.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),b.fog&&o.enable(0),b.useFog&&o.enable(1),b.flatShading&&o.enable(2),b.logarithmicDepthBuffer&&o.enable(3),b.reversedDepthBuffer&&o.enable(4),b.skinning&&o.enable(5),b.morphTargets&&o.enable(6),b.morphNormals&&o.enable(7),b.morphColors&&o.enable(8),b.premultipliedAlpha&&o.enable(9),b.shadowMapEnabled&&o.enable(10),b.doubleSided&&o.enable(11),b.flipSided&&o.enable(12),b.useDepthPacking&&o.enable(13),b.dithering&&o.enable(14),b.transmission&&o.enable(15),b.sheen&&o.enable(16),b.opaque&&o.enable(17),b.pointsUvs&&o.enable(18),b.decodeVideoTexture&&o.enable(19),b.decodeVideoTextureEmissive&&o.enable(20),b.alphaToCoverage&&o.enable(21),b.numLightProbeGrids>0&&o.enable(22),b.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let b=h[x.type],N;if(b){let R=hs[b];N=y0.clone(R.uniforms)}else N=x.uniforms;return N}function A(x,b){let N=u.get(b);return N!==void 0?++N.usedTimes:(N=new s1(i,b,x,s),l.push(N),u.set(b,N)),N}function S(x){if(--x.usedTimes===0){let b=l.indexOf(x);l[b]=l[l.length-1],l.pop(),u.delete(x.cacheKey),x.destroy()}}function P(x){a.remove(x)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:_,getUniforms:y,acquireProgram:A,releaseProgram:S,releaseShaderCache:P,programs:l,dispose:E}}function l1(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function c1(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function z0(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function G0(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,p,_,g,m){let y=i[e];return y===void 0?(y={id:h.id,object:h,geometry:f,material:p,materialVariant:o(h),groupOrder:_,renderOrder:h.renderOrder,z:g,group:m},i[e]=y):(y.id=h.id,y.object=h,y.geometry=f,y.material=p,y.materialVariant=o(h),y.groupOrder=_,y.renderOrder=h.renderOrder,y.z=g,y.group=m),e++,y}function c(h,f,p,_,g,m,y){y.reversedDepth===!0&&(g=-g);let A=a(h,f,p,_,g,m);p.transmission>0?n.push(A):p.transparent===!0?s.push(A):t.push(A)}function l(h,f,p,_,g,m){let y=a(h,f,p,_,g,m);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):t.unshift(y)}function u(h,f){t.length>1&&t.sort(h||c1),n.length>1&&n.sort(f||z0),s.length>1&&s.sort(f||z0)}function d(){for(let h=e,f=i.length;h<f;h++){let p=i[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:d,sort:u}}function u1(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new G0,i.set(n,[o])):s>=r.length?(o=new G0,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function h1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new ee,color:new yt};break;case"SpotLight":t={position:new ee,direction:new ee,color:new yt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new ee,color:new yt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new ee,skyColor:new yt,groundColor:new yt};break;case"RectAreaLight":t={color:new yt,position:new ee,halfWidth:new ee,halfHeight:new ee};break}return i[e.id]=t,t}}}function d1(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Tt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var f1=0;function p1(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function m1(i){let e=new h1,t=d1(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new ee);let s=new ee,r=new ln,o=new ln;function a(l){let u=0,d=0,h=0;for(let z=0;z<9;z++)n.probe[z].set(0,0,0);let f=0,p=0,_=0,g=0,m=0,y=0,A=0,S=0,P=0,E=0,x=0,b=0,N=0,R=0;l.sort(p1);for(let z=0,H=l.length;z<H;z++){let D=l[z],G=D.color,k=D.intensity,U=D.distance,se=null;if(D.shadow&&D.shadow.map&&(D.shadow.map.texture.format===hr?se=D.shadow.map.texture:se=D.shadow.map.depthTexture||D.shadow.map.texture),D.isAmbientLight)u+=G.r*k,d+=G.g*k,h+=G.b*k;else if(D.isLightProbe){for(let X=0;X<9;X++)n.probe[X].addScaledVector(D.sh.coefficients[X],k);R++}else if(D.isSunLight){let X=e.get(D);if(X.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Y=D.shadow,ie=t.get(D);ie.shadowIntensity=Y.intensity,ie.shadowBias=Y.bias,ie.shadowNormalBias=Y.normalBias,ie.shadowRadius=Y.radius,ie.shadowMapSize.copy(Y.mapSize).multiply(Y.getFrameExtents()),n.sunShadow[p]=ie,n.sunShadowMap[p]=se;let ce=Y.getViewportCount();for(let he=0;he<ce;he++)n.sunShadowMatrix[_+he]=Y.getMatrix(he),n.sunShadowCascade[_+he]=Y._cascadeData[he];_+=ce,p++}n.sun[f]=X,f++}else if(D.isDirectionalLight){let X=e.get(D);if(X.color.copy(D.color).multiplyScalar(D.intensity),D.castShadow){let Y=D.shadow,ie=t.get(D);ie.shadowIntensity=Y.intensity,ie.shadowBias=Y.bias,ie.shadowNormalBias=Y.normalBias,ie.shadowRadius=Y.radius,ie.shadowMapSize=Y.mapSize,n.directionalShadow[g]=ie,n.directionalShadowMap[g]=se,n.directionalShadowMatrix[g]=D.shadow.matrix,P++}n.directional[g]=X,g++}else if(D.isSpotLight){let X=e.get(D);X.position.setFromMatrixPosition(D.matrixWorld),X.color.copy(G).multiplyScalar(k),X.distance=U,X.coneCos=Math.cos(D.angle),X.penumbraCos=Math.cos(D.angle*(1-D.penumbra)),X.decay=D.decay,n.spot[y]=X;let Y=D.shadow;if(D.map&&(n.spotLightMap[b]=D.map,b++,Y.updateMatrices(D),D.castShadow&&N++),n.spotLightMatrix[y]=Y.matrix,D.castShadow){let ie=t.get(D);ie.shadowIntensity=Y.intensity,ie.shadowBias=Y.bias,ie.shadowNormalBias=Y.normalBias,ie.shadowRadius=Y.radius,ie.shadowMapSize=Y.mapSize,n.spotShadow[y]=ie,n.spotShadowMap[y]=se,x++}y++}else if(D.isRectAreaLight){let X=e.get(D);X.color.copy(G).multiplyScalar(k),X.halfWidth.set(D.width*.5,0,0),X.halfHeight.set(0,D.height*.5,0),n.rectArea[A]=X,A++}else if(D.isPointLight){let X=e.get(D);if(X.color.copy(D.color).multiplyScalar(D.intensity),X.distance=D.distance,X.decay=D.decay,D.castShadow){let Y=D.shadow,ie=t.get(D);ie.shadowIntensity=Y.intensity,ie.shadowBias=Y.bias,ie.shadowNormalBias=Y.normalBias,ie.shadowRadius=Y.radius,ie.shadowMapSize=Y.mapSize,ie.shadowCameraNear=Y.camera.near,ie.shadowCameraFar=Y.camera.far,n.pointShadow[m]=ie,n.pointShadowMap[m]=se,n.pointShadowMatrix[m]=D.shadow.matrix,E++}n.point[m]=X,m++}else if(D.isHemisphereLight){let X=e.get(D);X.skyColor.copy(D.color).multiplyScalar(k),X.groundColor.copy(D.groundColor).multiplyScalar(k),n.hemi[S]=X,S++}}A>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Be.LTC_FLOAT_1,n.rectAreaLTC2=Be.LTC_FLOAT_2):(n.rectAreaLTC1=Be.LTC_HALF_1,n.rectAreaLTC2=Be.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=d,n.ambient[2]=h;let L=n.hash;(L.sunLength!==f||L.directionalLength!==g||L.pointLength!==m||L.spotLength!==y||L.rectAreaLength!==A||L.hemiLength!==S||L.numSunShadows!==p||L.numDirectionalShadows!==P||L.numPointShadows!==E||L.numSpotShadows!==x||L.numSpotMaps!==b||L.numLightProbes!==R)&&(n.sun.length=f,n.directional.length=g,n.spot.length=y,n.rectArea.length=A,n.point.length=m,n.hemi.length=S,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=_,n.sunShadowCascade.length=_,n.directionalShadow.length=P,n.directionalShadowMap.length=P,n.directionalShadowMatrix.length=P,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=x,n.spotShadowMap.length=x,n.spotLightMatrix.length=x+b-N,n.spotLightMap.length=b,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=R,L.sunLength=f,L.directionalLength=g,L.pointLength=m,L.spotLength=y,L.rectAreaLength=A,L.hemiLength=S,L.numSunShadows=p,L.numDirectionalShadows=P,L.numPointShadows=E,L.numSpotShadows=x,L.numSpotMaps=b,L.numLightProbes=R,n.version=f1++)}function c(l,u){let d=0,h=0,f=0,p=0,_=0,g=0,m=u.matrixWorldInverse;for(let y=0,A=l.length;y<A;y++){let S=l[y];if(S.isSunLight){let P=n.sun[d];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(m),d++}else if(S.isDirectionalLight){let P=n.directional[h];P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),h++}else if(S.isSpotLight){let P=n.spot[p];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),P.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),P.direction.sub(s),P.direction.transformDirection(m),p++}else if(S.isRectAreaLight){let P=n.rectArea[_];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),o.identity(),r.copy(S.matrixWorld),r.premultiply(m),o.extractRotation(r),P.halfWidth.set(S.width*.5,0,0),P.halfHeight.set(0,S.height*.5,0),P.halfWidth.applyMatrix4(o),P.halfHeight.applyMatrix4(o),_++}else if(S.isPointLight){let P=n.point[f];P.position.setFromMatrixPosition(S.matrixWorld),P.position.applyMatrix4(m),f++}else if(S.isHemisphereLight){let P=n.hemi[g];P.direction.setFromMatrixPosition(S.matrixWorld),P.direction.transformDirection(m),g++}}}return{setup:a,setupView:c,state:n}}function V0(i){let e=new m1(i),t=[],n=[],s=[];function r(d){u.camera=d,t.length=0,n.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){n.push(d)}function c(){e.setup(t),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function l(d){e.setupView(t,d)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function g1(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new V0(i),e.set(s,[a])):r>=o.length?(a=new V0(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var x1=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,_1=`uniform sampler2D shadow_pass;
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
}`,v1=[new ee(1,0,0),new ee(-1,0,0),new ee(0,1,0),new ee(0,-1,0),new ee(0,0,1),new ee(0,0,-1)],y1=[new ee(0,-1,0),new ee(0,-1,0),new ee(0,0,1),new ee(0,0,-1),new ee(0,-1,0),new ee(0,-1,0)],H0=new ln,il=new ee,vf=new ee;function b1(i,e,t){let n=new rr,s=new Tt,r=new Tt,o=new un,a=new Rc,c=new Cc,l={},u=t.maxTextureSize,d={[ur]:ti,[ti]:ur,[Ii]:Ii},h=new ls({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Tt},radius:{value:4}},vertexShader:x1,fragmentShader:_1}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let p=new bi;p.setAttribute("position",new Pi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Bn(p,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=$a;let m=this.type;this.render=function(E,x,b){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||E.length===0)return;this.type===Og&&(ct("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=$a);let N=i.getRenderTarget(),R=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),z=i.state;z.setBlending(Lr),z.buffers.depth.getReversed()===!0?z.buffers.color.setClear(0,0,0,0):z.buffers.color.setClear(1,1,1,1),z.buffers.depth.setTest(!0),z.setScissorTest(!1);let H=m!==this.type;H&&x.traverse(function(D){D.material&&(Array.isArray(D.material)?D.material.forEach(G=>G.needsUpdate=!0):D.material.needsUpdate=!0)});for(let D=0,G=E.length;D<G;D++){let k=E[D],U=k.shadow;if(U===void 0){ct("WebGLShadowMap:",k,"has no shadow.");continue}if(U.autoUpdate===!1&&U.needsUpdate===!1)continue;s.copy(U.mapSize);let se=U.getFrameExtents();s.multiply(se),r.copy(U.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/se.x),s.x=r.x*se.x,U.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/se.y),s.y=r.y*se.y,U.mapSize.y=r.y));let X=i.state.buffers.depth.getReversed();if(U.camera._reversedDepth=X,U.map===null||H===!0){if(U.map!==null&&(U.map.depthTexture!==null&&(U.map.depthTexture.dispose(),U.map.depthTexture=null),U.map.dispose()),this.type===Oo){if(k.isPointLight){ct("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}U.map=new yi(s.x,s.y,{format:hr,type:Wi,minFilter:Qn,magFilter:Qn,generateMipmaps:!1}),U.map.texture.name=k.name+".shadowMap",U.map.depthTexture=new Ps(s.x,s.y,Hi),U.map.depthTexture.name=k.name+".shadowMapDepth",U.map.depthTexture.format=Rs,U.map.depthTexture.compareFunction=null,U.map.depthTexture.minFilter=On,U.map.depthTexture.magFilter=On}else k.isPointLight?(U.map=new rl(s.x),U.map.depthTexture=new Oa(s.x,Vi)):(U.map=new yi(s.x,s.y),U.map.depthTexture=new Ps(s.x,s.y,Vi)),U.map.depthTexture.name=k.name+".shadowMap",U.map.depthTexture.format=Rs,this.type===$a?(U.map.depthTexture.compareFunction=X?cf:lf,U.map.depthTexture.minFilter=Qn,U.map.depthTexture.magFilter=Qn):(U.map.depthTexture.compareFunction=null,U.map.depthTexture.minFilter=On,U.map.depthTexture.magFilter=On);U.camera.updateProjectionMatrix()}U.map.isWebGLCubeRenderTarget!==!0&&(U.map.width!==s.x||U.map.height!==s.y)&&U.map.setSize(s.x,s.y);let Y=U.map.isWebGLCubeRenderTarget?6:U.getViewportCount();k.isPointLight!==!0&&U.updateMatrices(k,b);let ie=(U.camera.layers.mask&4294967294)!==0?U.camera.layers:b.layers;for(let ce=0;ce<Y;ce++){let he=U.getCamera(ce);if(k.isPointLight){let Q=U.camera,ge=U.matrix,_e=k.distance||Q.far;_e!==Q.far&&(Q.far=_e,Q.updateProjectionMatrix()),il.setFromMatrixPosition(k.matrixWorld),Q.position.copy(il),vf.copy(Q.position),vf.add(v1[ce]),Q.up.copy(y1[ce]),Q.lookAt(vf),Q.updateMatrixWorld(),ge.makeTranslation(-il.x,-il.y,-il.z),H0.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),U._frustum.setFromProjectionMatrix(H0,Q.coordinateSystem,Q.reversedDepth)}if(U.map.isWebGLCubeRenderTarget)i.setRenderTarget(U.map,ce),i.clear();else{ce===0&&(i.setRenderTarget(U.map),i.clear());let Q=U.getViewport(ce);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),z.viewport(o)}n=U.getFrustum(ce),S(x,b,he,k,ie,this.type)}U.isPointLightShadow!==!0&&this.type===Oo&&y(U,b),U.needsUpdate=!1}m=this.type,g.needsUpdate=!1,i.setRenderTarget(N,R,L)};function y(E,x){let b=e.update(_);h.defines.VSM_SAMPLES!==E.blurSamples&&(h.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new yi(s.x,s.y,{format:hr,type:Wi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),h.uniforms.shadow_pass.value=E.map.depthTexture,h.uniforms.resolution.value.set(E.map.width,E.map.height),h.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(x,null,b,h,_,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(x,null,b,f,_,null)}function A(E,x,b,N){let R=null,L=b.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(L!==void 0)R=L;else if(R=b.isPointLight===!0?c:a,i.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let z=R.uuid,H=x.uuid,D=l[z];D===void 0&&(D={},l[z]=D);let G=D[H];G===void 0&&(G=R.clone(),D[H]=G,x.addEventListener("dispose",P)),R=G}if(R.visible=x.visible,R.wireframe=x.wireframe,N===Oo?R.side=x.shadowSide!==null?x.shadowSide:x.side:R.side=x.shadowSide!==null?x.shadowSide:d[x.side],R.alphaMap=x.alphaMap,R.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,R.map=x.map,R.clipShadows=x.clipShadows,R.clippingPlanes=x.clippingPlanes,R.clipIntersection=x.clipIntersection,R.displacementMap=x.displacementMap,R.displacementScale=x.displacementScale,R.displacementBias=x.displacementBias,R.wireframeLinewidth=x.wireframeLinewidth,R.linewidth=x.linewidth,b.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let z=i.properties.get(R);z.light=b}return R}function S(E,x,b,N,R,L){if(E.visible===!1)return;if(E.layers.test(R)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&L===Oo)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(b.matrixWorldInverse,E.matrixWorld);let D=e.update(E),G=E.material;if(Array.isArray(G)){let k=D.groups;for(let U=0,se=k.length;U<se;U++){let X=k[U],Y=G[X.materialIndex];if(Y&&Y.visible){let ie=A(E,Y,N,L);E.onBeforeShadow(i,E,x,b,D,ie,X),i.renderBufferDirect(b,null,D,ie,E,X),E.onAfterShadow(i,E,x,b,D,ie,X)}}}else if(G.visible){let k=A(E,G,N,L);E.onBeforeShadow(i,E,x,b,D,k,null),i.renderBufferDirect(b,null,D,k,E,null),E.onAfterShadow(i,E,x,b,D,k,null)}}let H=E.children;for(let D=0,G=H.length;D<G;D++)S(H[D],x,b,N,R,L)}function P(E){E.target.removeEventListener("dispose",P);for(let b in l){let N=l[b],R=E.target.uuid;R in N&&(N[R].dispose(),delete N[R])}}}function M1(i,e){function t(){let B=!1,ae=new un,re=null,Ae=new un(0,0,0,0);return{setMask:function(Me){re!==Me&&!B&&(i.colorMask(Me,Me,Me,Me),re=Me)},setLocked:function(Me){B=Me},setClear:function(Me,Ee,je,st,de){de===!0&&(Me*=st,Ee*=st,je*=st),ae.set(Me,Ee,je,st),Ae.equals(ae)===!1&&(i.clearColor(Me,Ee,je,st),Ae.copy(ae))},reset:function(){B=!1,re=null,Ae.set(-1,0,0,0)}}}function n(){let B=!1,ae=!1,re=null,Ae=null,Me=null;return{setReversed:function(Ee){if(ae!==Ee){let je=e.get("EXT_clip_control");Ee?je.clipControlEXT(je.LOWER_LEFT_EXT,je.ZERO_TO_ONE_EXT):je.clipControlEXT(je.LOWER_LEFT_EXT,je.NEGATIVE_ONE_TO_ONE_EXT),ae=Ee;let st=Me;Me=null,this.setClear(st)}},getReversed:function(){return ae},setTest:function(Ee){Ee?xe(i.DEPTH_TEST):Ge(i.DEPTH_TEST)},setMask:function(Ee){re!==Ee&&!B&&(i.depthMask(Ee),re=Ee)},setFunc:function(Ee){if(ae&&(Ee=x0[Ee]),Ae!==Ee){switch(Ee){case uc:i.depthFunc(i.NEVER);break;case hc:i.depthFunc(i.ALWAYS);break;case dc:i.depthFunc(i.LESS);break;case Ao:i.depthFunc(i.LEQUAL);break;case fc:i.depthFunc(i.EQUAL);break;case pc:i.depthFunc(i.GEQUAL);break;case mc:i.depthFunc(i.GREATER);break;case gc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Ae=Ee}},setLocked:function(Ee){B=Ee},setClear:function(Ee){Me!==Ee&&(Me=Ee,ae&&(Ee=1-Ee),i.clearDepth(Ee))},reset:function(){B=!1,re=null,Ae=null,Me=null,ae=!1}}}function s(){let B=!1,ae=null,re=null,Ae=null,Me=null,Ee=null,je=null,st=null,de=null;return{setTest:function(He){B||(He?xe(i.STENCIL_TEST):Ge(i.STENCIL_TEST))},setMask:function(He){ae!==He&&!B&&(i.stencilMask(He),ae=He)},setFunc:function(He,nt,Pe){(re!==He||Ae!==nt||Me!==Pe)&&(i.stencilFunc(He,nt,Pe),re=He,Ae=nt,Me=Pe)},setOp:function(He,nt,Pe){(Ee!==He||je!==nt||st!==Pe)&&(i.stencilOp(He,nt,Pe),Ee=He,je=nt,st=Pe)},setLocked:function(He){B=He},setClear:function(He){de!==He&&(i.clearStencil(He),de=He)},reset:function(){B=!1,ae=null,re=null,Ae=null,Me=null,Ee=null,je=null,st=null,de=null}}}let r=new t,o=new n,a=new s,c={},l=new WeakMap,u={},d={},h={},f=new WeakMap,p=[],_=null,g=!1,m=null,y=null,A=null,S=null,P=null,E=null,x=null,b=new yt(0,0,0),N=0,R=!1,L=null,z=null,H=null,D=null,G=null,k=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),U=!1,se=0,X=i.getParameter(i.VERSION);X.indexOf("WebGL")!==-1?(se=parseFloat(/^WebGL (\d)/.exec(X)[1]),U=se>=1):X.indexOf("OpenGL ES")!==-1&&(se=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),U=se>=2);let Y=null,ie={},ce=i.getParameter(i.SCISSOR_BOX),he=i.getParameter(i.VIEWPORT),Q=new un().fromArray(ce),ge=new un().fromArray(he);function _e(B,ae,re,Ae){let Me=new Uint8Array(4),Ee=i.createTexture();i.bindTexture(B,Ee),i.texParameteri(B,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(B,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let je=0;je<re;je++)B===i.TEXTURE_3D||B===i.TEXTURE_2D_ARRAY?i.texImage3D(ae,0,i.RGBA,1,1,Ae,0,i.RGBA,i.UNSIGNED_BYTE,Me):i.texImage2D(ae+je,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,Me);return Ee}let Te={};Te[i.TEXTURE_2D]=_e(i.TEXTURE_2D,i.TEXTURE_2D,1),Te[i.TEXTURE_CUBE_MAP]=_e(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Te[i.TEXTURE_2D_ARRAY]=_e(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Te[i.TEXTURE_3D]=_e(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xe(i.DEPTH_TEST),o.setFunc(Ao),Fe(!1),We(zd),xe(i.CULL_FACE),ve(Lr);function xe(B){u[B]!==!0&&(i.enable(B),u[B]=!0)}function Ge(B){u[B]!==!1&&(i.disable(B),u[B]=!1)}function qe(B,ae){return h[B]!==ae?(i.bindFramebuffer(B,ae),h[B]=ae,B===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=ae),B===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=ae),!0):!1}function ke(B,ae){let re=p,Ae=!1;if(B){re=f.get(ae),re===void 0&&(re=[],f.set(ae,re));let Me=B.textures;if(re.length!==Me.length||re[0]!==i.COLOR_ATTACHMENT0){for(let Ee=0,je=Me.length;Ee<je;Ee++)re[Ee]=i.COLOR_ATTACHMENT0+Ee;re.length=Me.length,Ae=!0}}else re[0]!==i.BACK&&(re[0]=i.BACK,Ae=!0);Ae&&i.drawBuffers(re)}function it(B){return _!==B?(i.useProgram(B),_=B,!0):!1}let ot={[Dr]:i.FUNC_ADD,[kg]:i.FUNC_SUBTRACT,[zg]:i.FUNC_REVERSE_SUBTRACT};ot[Gg]=i.MIN,ot[Vg]=i.MAX;let rt={[Hg]:i.ZERO,[Wg]:i.ONE,[Xg]:i.SRC_COLOR,[Wd]:i.SRC_ALPHA,[Kg]:i.SRC_ALPHA_SATURATE,[Zg]:i.DST_COLOR,[Yg]:i.DST_ALPHA,[qg]:i.ONE_MINUS_SRC_COLOR,[Xd]:i.ONE_MINUS_SRC_ALPHA,[Jg]:i.ONE_MINUS_DST_COLOR,[$g]:i.ONE_MINUS_DST_ALPHA,[jg]:i.CONSTANT_COLOR,[Qg]:i.ONE_MINUS_CONSTANT_COLOR,[e0]:i.CONSTANT_ALPHA,[t0]:i.ONE_MINUS_CONSTANT_ALPHA};function ve(B,ae,re,Ae,Me,Ee,je,st,de,He){if(B===Lr){g===!0&&(Ge(i.BLEND),g=!1);return}if(g===!1&&(xe(i.BLEND),g=!0),B!==Bg){if(B!==m||He!==R){if((y!==Dr||P!==Dr)&&(i.blendEquation(i.FUNC_ADD),y=Dr,P=Dr),He)switch(B){case Bo:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Gd:i.blendFunc(i.ONE,i.ONE);break;case Vd:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Hd:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:dt("WebGLState: Invalid blending: ",B);break}else switch(B){case Bo:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Gd:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Vd:dt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Hd:dt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:dt("WebGLState: Invalid blending: ",B);break}A=null,S=null,E=null,x=null,b.set(0,0,0),N=0,m=B,R=He}return}Me=Me||ae,Ee=Ee||re,je=je||Ae,(ae!==y||Me!==P)&&(i.blendEquationSeparate(ot[ae],ot[Me]),y=ae,P=Me),(re!==A||Ae!==S||Ee!==E||je!==x)&&(i.blendFuncSeparate(rt[re],rt[Ae],rt[Ee],rt[je]),A=re,S=Ae,E=Ee,x=je),(st.equals(b)===!1||de!==N)&&(i.blendColor(st.r,st.g,st.b,de),b.copy(st),N=de),m=B,R=!1}function me(B,ae){B.side===Ii?Ge(i.CULL_FACE):xe(i.CULL_FACE);let re=B.side===ti;ae&&(re=!re),Fe(re),B.blending===Bo&&B.transparent===!1?ve(Lr):ve(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let Ae=B.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),ut(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?xe(i.SAMPLE_ALPHA_TO_COVERAGE):Ge(i.SAMPLE_ALPHA_TO_COVERAGE)}function Fe(B){L!==B&&(B?i.frontFace(i.CW):i.frontFace(i.CCW),L=B)}function We(B){B!==Ug?(xe(i.CULL_FACE),B!==z&&(B===zd?i.cullFace(i.BACK):B===Fg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Ge(i.CULL_FACE),z=B}function at(B){B!==H&&(U&&i.lineWidth(B),H=B)}function ut(B,ae,re){B?(xe(i.POLYGON_OFFSET_FILL),(D!==ae||G!==re)&&(D=ae,G=re,o.getReversed()&&(ae=-ae,re=-re),i.polygonOffset(ae,re))):Ge(i.POLYGON_OFFSET_FILL)}function Kt(B){B?xe(i.SCISSOR_TEST):Ge(i.SCISSOR_TEST)}function Yt(B){B===void 0&&(B=i.TEXTURE0+k-1),Y!==B&&(i.activeTexture(B),Y=B)}function zt(B,ae,re){re===void 0&&(Y===null?re=i.TEXTURE0+k-1:re=Y);let Ae=ie[re];Ae===void 0&&(Ae={type:void 0,texture:void 0},ie[re]=Ae),(Ae.type!==B||Ae.texture!==ae)&&(Y!==re&&(i.activeTexture(re),Y=re),i.bindTexture(B,ae||Te[B]),Ae.type=B,Ae.texture=ae)}function O(){let B=ie[Y];B!==void 0&&B.type!==void 0&&(i.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function De(){try{i.compressedTexImage2D(...arguments)}catch(B){dt("WebGLState:",B)}}function tt(){try{i.compressedTexImage3D(...arguments)}catch(B){dt("WebGLState:",B)}}function ft(){try{i.texSubImage2D(...arguments)}catch(B){dt("WebGLState:",B)}}function Ce(){try{i.texSubImage3D(...arguments)}catch(B){dt("WebGLState:",B)}}function Pt(){try{i.compressedTexSubImage2D(...arguments)}catch(B){dt("WebGLState:",B)}}function Ye(){try{i.compressedTexSubImage3D(...arguments)}catch(B){dt("WebGLState:",B)}}function et(){try{i.texStorage2D(...arguments)}catch(B){dt("WebGLState:",B)}}function C(){try{i.texStorage3D(...arguments)}catch(B){dt("WebGLState:",B)}}function M(){try{i.texImage2D(...arguments)}catch(B){dt("WebGLState:",B)}}function q(){try{i.texImage3D(...arguments)}catch(B){dt("WebGLState:",B)}}function fe(B){return d[B]!==void 0?d[B]:i.getParameter(B)}function le(B,ae){d[B]!==ae&&(i.pixelStorei(B,ae),d[B]=ae)}function Se(B){Q.equals(B)===!1&&(i.scissor(B.x,B.y,B.z,B.w),Q.copy(B))}function we(B){ge.equals(B)===!1&&(i.viewport(B.x,B.y,B.z,B.w),ge.copy(B))}function te(B,ae){let re=l.get(ae);re===void 0&&(re=new WeakMap,l.set(ae,re));let Ae=re.get(B);Ae===void 0&&(Ae=i.getUniformBlockIndex(ae,B.name),i.uniformBlockBinding(ae,Ae,Ae),re.set(B,Ae))}function oe(B,ae,re){let Me=l.get(ae).get(B);c[Me]!==re&&(i.bindBufferBase(i.UNIFORM_BUFFER,Me,re),c[Me]=re)}function ye(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},d={},Y=null,ie={},h={},c={},f=new WeakMap,p=[],_=null,g=!1,m=null,y=null,A=null,S=null,P=null,E=null,x=null,b=new yt(0,0,0),N=0,R=!1,L=null,z=null,H=null,D=null,G=null,Q.set(0,0,i.canvas.width,i.canvas.height),ge.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:xe,disable:Ge,bindFramebuffer:qe,drawBuffers:ke,useProgram:it,setBlending:ve,setMaterial:me,setFlipSided:Fe,setCullFace:We,setLineWidth:at,setPolygonOffset:ut,setScissorTest:Kt,activeTexture:Yt,bindTexture:zt,unbindTexture:O,compressedTexImage2D:De,compressedTexImage3D:tt,texImage2D:M,texImage3D:q,pixelStorei:le,getParameter:fe,updateUBOMapping:te,uniformBlockBinding:oe,texStorage2D:et,texStorage3D:C,texSubImage2D:ft,texSubImage3D:Ce,compressedTexSubImage2D:Pt,compressedTexSubImage3D:Ye,scissor:Se,viewport:we,reset:ye}}function S1(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Tt,u=new WeakMap,d=new Set,h,f=new WeakMap,p=new Set,_=new FinalizationRegistry(C=>p.delete(C)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(C,M){return g?new OffscreenCanvas(C,M):Ca("canvas")}function y(C,M,q){let fe=1,le=et(C);if((le.width>q||le.height>q)&&(fe=q/Math.max(le.width,le.height)),fe<1)if(typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&C instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&C instanceof ImageBitmap||typeof VideoFrame<"u"&&C instanceof VideoFrame){let Se=Math.floor(fe*le.width),we=Math.floor(fe*le.height);h===void 0&&(h=m(Se,we));let te=M?m(Se,we):h;return te.width=Se,te.height=we,te.getContext("2d").drawImage(C,0,0,Se,we),ct("WebGLRenderer: Texture has been resized from ("+le.width+"x"+le.height+") to ("+Se+"x"+we+")."),te}else return"data"in C&&ct("WebGLRenderer: Image in DataTexture is too big ("+le.width+"x"+le.height+")."),C;return C}function A(C){return C.generateMipmaps}function S(C){i.generateMipmap(C)}function P(C){return C.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:C.isWebGL3DRenderTarget?i.TEXTURE_3D:C.isWebGLArrayRenderTarget||C.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(C,M,q,fe,le,Se=!1){if(C!==null){if(i[C]!==void 0)return i[C];ct("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+C+"'")}let we;fe&&(we=e.get("EXT_texture_norm16"),we||ct("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===i.RED&&(q===i.FLOAT&&(te=i.R32F),q===i.HALF_FLOAT&&(te=i.R16F),q===i.UNSIGNED_BYTE&&(te=i.R8),q===i.UNSIGNED_SHORT&&we&&(te=we.R16_EXT),q===i.SHORT&&we&&(te=we.R16_SNORM_EXT)),M===i.RED_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.R8UI),q===i.UNSIGNED_SHORT&&(te=i.R16UI),q===i.UNSIGNED_INT&&(te=i.R32UI),q===i.BYTE&&(te=i.R8I),q===i.SHORT&&(te=i.R16I),q===i.INT&&(te=i.R32I)),M===i.RG&&(q===i.FLOAT&&(te=i.RG32F),q===i.HALF_FLOAT&&(te=i.RG16F),q===i.UNSIGNED_BYTE&&(te=i.RG8),q===i.UNSIGNED_SHORT&&we&&(te=we.RG16_EXT),q===i.SHORT&&we&&(te=we.RG16_SNORM_EXT)),M===i.RG_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RG8UI),q===i.UNSIGNED_SHORT&&(te=i.RG16UI),q===i.UNSIGNED_INT&&(te=i.RG32UI),q===i.BYTE&&(te=i.RG8I),q===i.SHORT&&(te=i.RG16I),q===i.INT&&(te=i.RG32I)),M===i.RGB_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RGB8UI),q===i.UNSIGNED_SHORT&&(te=i.RGB16UI),q===i.UNSIGNED_INT&&(te=i.RGB32UI),q===i.BYTE&&(te=i.RGB8I),q===i.SHORT&&(te=i.RGB16I),q===i.INT&&(te=i.RGB32I)),M===i.RGBA_INTEGER&&(q===i.UNSIGNED_BYTE&&(te=i.RGBA8UI),q===i.UNSIGNED_SHORT&&(te=i.RGBA16UI),q===i.UNSIGNED_INT&&(te=i.RGBA32UI),q===i.BYTE&&(te=i.RGBA8I),q===i.SHORT&&(te=i.RGBA16I),q===i.INT&&(te=i.RGBA32I)),M===i.RGB&&(q===i.UNSIGNED_SHORT&&we&&(te=we.RGB16_EXT),q===i.SHORT&&we&&(te=we.RGB16_SNORM_EXT),q===i.UNSIGNED_INT_5_9_9_9_REV&&(te=i.RGB9_E5),q===i.UNSIGNED_INT_10F_11F_11F_REV&&(te=i.R11F_G11F_B10F)),M===i.RGBA){let oe=Se?Ra:Rt.getTransfer(le);q===i.FLOAT&&(te=i.RGBA32F),q===i.HALF_FLOAT&&(te=i.RGBA16F),q===i.UNSIGNED_BYTE&&(te=oe===kt?i.SRGB8_ALPHA8:i.RGBA8),q===i.UNSIGNED_SHORT&&we&&(te=we.RGBA16_EXT),q===i.SHORT&&we&&(te=we.RGBA16_SNORM_EXT),q===i.UNSIGNED_SHORT_4_4_4_4&&(te=i.RGBA4),q===i.UNSIGNED_SHORT_5_5_5_1&&(te=i.RGB5_A1)}return(te===i.R16F||te===i.R32F||te===i.RG16F||te===i.RG32F||te===i.RGBA16F||te===i.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(C,M){let q;return C?M===null||M===Vi||M===Ur?q=i.DEPTH24_STENCIL8:M===Hi?q=i.DEPTH32F_STENCIL8:M===zo&&(q=i.DEPTH24_STENCIL8,ct("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===Vi||M===Ur?q=i.DEPTH_COMPONENT24:M===Hi?q=i.DEPTH_COMPONENT32F:M===zo&&(q=i.DEPTH_COMPONENT16),q}function b(C,M){return A(C)===!0||C.isFramebufferTexture&&C.minFilter!==On&&C.minFilter!==Qn?Math.log2(Math.max(M.width,M.height))+1:C.mipmaps.length>0?C.mipmaps.length:C.isCompressedTexture&&Array.isArray(C.image)?M.mipmaps.length:1}function N(C){let M=new WeakRef(C);n.get(C).__ref=M,p.add(M),_.register(C,M,M)}function R(C){let M=n.get(C).__ref;M!==void 0&&(p.delete(M),_.unregister(M))}function L(C){H(C.target)}function z(C){D(C.target)}function H(C){C.removeEventListener("dispose",L),R(C),k(C),C.isVideoTexture&&u.delete(C),C.isHTMLTexture&&d.delete(C)}function D(C){C.removeEventListener("dispose",z),R(C),se(C)}function G(){for(let C of p){let M=C.deref();M!==void 0&&(M.isRenderTarget===!0?D(M):H(M))}p.clear(),d.clear()}function k(C){let M=n.get(C);if(M.__webglInit===void 0)return;let q=C.source,fe=f.get(q);if(fe){let le=fe[M.__cacheKey];le.usedTimes--,le.usedTimes===0&&U(C),Object.keys(fe).length===0&&f.delete(q)}n.remove(C)}function U(C){let M=n.get(C);i.deleteTexture(M.__webglTexture);let q=C.source,fe=f.get(q);delete fe[M.__cacheKey],o.memory.textures--}function se(C){let M=n.get(C);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=C.depthTexture;if(q&&q.renderTarget===C&&H(q),C.isWebGLCubeRenderTarget)for(let le=0;le<6;le++){if(Array.isArray(M.__webglFramebuffer[le]))for(let Se=0;Se<M.__webglFramebuffer[le].length;Se++)i.deleteFramebuffer(M.__webglFramebuffer[le][Se]);else i.deleteFramebuffer(M.__webglFramebuffer[le]);M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer[le])}else{if(Array.isArray(M.__webglFramebuffer))for(let le=0;le<M.__webglFramebuffer.length;le++)i.deleteFramebuffer(M.__webglFramebuffer[le]);else i.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&i.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&i.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let le=0;le<M.__webglColorRenderbuffer.length;le++)M.__webglColorRenderbuffer[le]&&i.deleteRenderbuffer(M.__webglColorRenderbuffer[le]);M.__webglDepthRenderbuffer&&i.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let fe=C.textures;for(let le=0,Se=fe.length;le<Se;le++){let we=n.get(fe[le]);we.__webglTexture&&(i.deleteTexture(we.__webglTexture),o.memory.textures--),n.remove(fe[le])}n.remove(C)}let X=0;function Y(){X=0}function ie(){return X}function ce(C){X=C}function he(){let C=X;return C>=s.maxTextures&&ct("WebGLTextures: Trying to use "+(C+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,C}function Q(C){let M=[];return M.push(C.wrapS),M.push(C.wrapT),M.push(C.wrapR||0),M.push(C.magFilter),M.push(C.minFilter),M.push(C.anisotropy),M.push(C.internalFormat),M.push(C.format),M.push(C.type),M.push(C.generateMipmaps),M.push(C.mipmapsAutoUpdate),M.push(C.premultiplyAlpha),M.push(C.flipY),M.push(C.unpackAlignment),M.push(C.colorSpace),M.join()}function ge(C,M){let q=n.get(C);if(C.isVideoTexture&&Pt(C),C.isRenderTargetTexture===!1&&C.isExternalTexture!==!0&&C.version>0&&q.__version!==C.version){let fe=C.image;if(fe===null)ct("WebGLRenderer: Texture marked for update but no image data found.");else if(fe.complete===!1)ct("WebGLRenderer: Texture marked for update but image is incomplete");else{me(q,C,M);return}}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,q.__webglTexture,i.TEXTURE0+M)}function _e(C,M){let q=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){me(q,C,M);return}else C.isExternalTexture&&(q.__webglTexture=C.sourceTexture?C.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,q.__webglTexture,i.TEXTURE0+M)}function Te(C,M){let q=n.get(C);if(C.isRenderTargetTexture===!1&&C.version>0&&q.__version!==C.version){me(q,C,M);return}t.bindTexture(i.TEXTURE_3D,q.__webglTexture,i.TEXTURE0+M)}function xe(C,M){let q=n.get(C);if(C.version>0&&q.__version!==C.version){Fe(q,C,M);return}t.bindTexture(i.TEXTURE_CUBE_MAP,q.__webglTexture,i.TEXTURE0+M)}let Ge={[xc]:i.REPEAT,[ss]:i.CLAMP_TO_EDGE,[_c]:i.MIRRORED_REPEAT},qe={[On]:i.NEAREST,[s0]:i.NEAREST_MIPMAP_NEAREST,[Za]:i.NEAREST_MIPMAP_LINEAR,[Qn]:i.LINEAR,[Xc]:i.LINEAR_MIPMAP_NEAREST,[Is]:i.LINEAR_MIPMAP_LINEAR},ke={[l0]:i.NEVER,[uf]:i.ALWAYS,[c0]:i.LESS,[lf]:i.LEQUAL,[u0]:i.EQUAL,[cf]:i.GEQUAL,[h0]:i.GREATER,[d0]:i.NOTEQUAL};function it(C,M){if(M.type===Hi&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===Qn||M.magFilter===Xc||M.magFilter===Za||M.magFilter===Is||M.minFilter===Qn||M.minFilter===Xc||M.minFilter===Za||M.minFilter===Is)&&ct("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(C,i.TEXTURE_WRAP_S,Ge[M.wrapS]),i.texParameteri(C,i.TEXTURE_WRAP_T,Ge[M.wrapT]),(C===i.TEXTURE_3D||C===i.TEXTURE_2D_ARRAY)&&i.texParameteri(C,i.TEXTURE_WRAP_R,Ge[M.wrapR]),i.texParameteri(C,i.TEXTURE_MAG_FILTER,qe[M.magFilter]),i.texParameteri(C,i.TEXTURE_MIN_FILTER,qe[M.minFilter]),M.compareFunction&&(i.texParameteri(C,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(C,i.TEXTURE_COMPARE_FUNC,ke[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===On||M.minFilter!==Za&&M.minFilter!==Is||M.type===Hi&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||n.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");i.texParameterf(C,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),n.get(M).__currentAnisotropy=M.anisotropy}}}function ot(C,M){let q=!1;C.__webglInit===void 0&&(C.__webglInit=!0,M.addEventListener("dispose",L),N(M));let fe=M.source,le=f.get(fe);le===void 0&&(le={},f.set(fe,le));let Se=Q(M);if(Se!==C.__cacheKey){le[Se]===void 0&&(le[Se]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,q=!0),le[Se].usedTimes++;let we=le[C.__cacheKey];we!==void 0&&(le[C.__cacheKey].usedTimes--,we.usedTimes===0&&U(M)),C.__cacheKey=Se,C.__webglTexture=le[Se].texture}return q}function rt(C,M,q){return Math.floor(Math.floor(C/q)/M)}function ve(C,M,q,fe){let Se=C.updateRanges;if(Se.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,M.width,M.height,q,fe,M.data);else{Se.sort((B,ae)=>B.start-ae.start);let we=0;for(let B=1;B<Se.length;B++){let ae=Se[we],re=Se[B],Ae=ae.start+ae.count,Me=rt(re.start,M.width,4),Ee=rt(ae.start,M.width,4);re.start<=Ae+1&&Me===Ee&&rt(re.start+re.count-1,M.width,4)===Me?ae.count=Math.max(ae.count,re.start+re.count-ae.start):(++we,Se[we]=re)}Se.length=we+1;let te=t.getParameter(i.UNPACK_ROW_LENGTH),oe=t.getParameter(i.UNPACK_SKIP_PIXELS),ye=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,M.width);for(let B=0,ae=Se.length;B<ae;B++){let re=Se[B],Ae=Math.floor(re.start/4),Me=Math.ceil(re.count/4),Ee=Ae%M.width,je=Math.floor(Ae/M.width),st=Me,de=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,Ee),t.pixelStorei(i.UNPACK_SKIP_ROWS,je),t.texSubImage2D(i.TEXTURE_2D,0,Ee,je,st,de,q,fe,M.data)}C.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,te),t.pixelStorei(i.UNPACK_SKIP_PIXELS,oe),t.pixelStorei(i.UNPACK_SKIP_ROWS,ye)}}function me(C,M,q){let fe=i.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(fe=i.TEXTURE_2D_ARRAY),M.isData3DTexture&&(fe=i.TEXTURE_3D);let le=ot(C,M),Se=M.source;t.bindTexture(fe,C.__webglTexture,i.TEXTURE0+q);let we=n.get(Se);if(Se.version!==we.__version||le===!0){if(t.activeTexture(i.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let de=Rt.getPrimaries(Rt.workingColorSpace),He=M.colorSpace===Ds?null:Rt.getPrimaries(M.colorSpace),nt=M.colorSpace===Ds||de===He?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt)}t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment);let oe=y(M.image,!1,s.maxTextureSize);oe=Ye(M,oe);let ye=r.convert(M.format,M.colorSpace),B=r.convert(M.type),ae=E(M.internalFormat,ye,B,M.normalized,M.colorSpace,M.isVideoTexture);it(fe,M);let re,Ae=M.mipmaps,Me=M.isVideoTexture!==!0,Ee=we.__version===void 0||le===!0,je=Se.dataReady,st=b(M,oe);if(M.isDepthTexture)ae=x(M.format===Ls,M.type),Ee&&(Me?t.texStorage2D(i.TEXTURE_2D,1,ae,oe.width,oe.height):t.texImage2D(i.TEXTURE_2D,0,ae,oe.width,oe.height,0,ye,B,null));else if(M.isDataTexture)if(Ae.length>0){Me&&Ee&&t.texStorage2D(i.TEXTURE_2D,st,ae,Ae[0].width,Ae[0].height);for(let de=0,He=Ae.length;de<He;de++)re=Ae[de],Me?je&&t.texSubImage2D(i.TEXTURE_2D,de,0,0,re.width,re.height,ye,B,re.data):t.texImage2D(i.TEXTURE_2D,de,ae,re.width,re.height,0,ye,B,re.data);M.generateMipmaps=!1}else Me?(Ee&&t.texStorage2D(i.TEXTURE_2D,st,ae,oe.width,oe.height),je&&ve(M,oe,ye,B)):t.texImage2D(i.TEXTURE_2D,0,ae,oe.width,oe.height,0,ye,B,oe.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){Me&&Ee&&t.texStorage3D(i.TEXTURE_2D_ARRAY,st,ae,Ae[0].width,Ae[0].height,oe.depth);for(let de=0,He=Ae.length;de<He;de++)if(re=Ae[de],M.format!==Xi)if(ye!==null)if(Me){if(je)if(M.layerUpdates.size>0){let nt=xf(re.width,re.height,M.format,M.type);for(let Pe of M.layerUpdates){let mt=re.data.subarray(Pe*nt/re.data.BYTES_PER_ELEMENT,(Pe+1)*nt/re.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,de,0,0,Pe,re.width,re.height,1,ye,mt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,de,0,0,0,re.width,re.height,oe.depth,ye,re.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,de,ae,re.width,re.height,oe.depth,0,re.data,0,0);else ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else Me?je&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,de,0,0,0,re.width,re.height,oe.depth,ye,B,re.data):t.texImage3D(i.TEXTURE_2D_ARRAY,de,ae,re.width,re.height,oe.depth,0,ye,B,re.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{Me&&Ee&&t.texStorage2D(i.TEXTURE_2D,st,ae,Ae[0].width,Ae[0].height);for(let de=0,He=Ae.length;de<He;de++)re=Ae[de],M.format!==Xi?ye!==null?Me?je&&t.compressedTexSubImage2D(i.TEXTURE_2D,de,0,0,re.width,re.height,ye,re.data):t.compressedTexImage2D(i.TEXTURE_2D,de,ae,re.width,re.height,0,re.data):ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):Me?je&&t.texSubImage2D(i.TEXTURE_2D,de,0,0,re.width,re.height,ye,B,re.data):t.texImage2D(i.TEXTURE_2D,de,ae,re.width,re.height,0,ye,B,re.data)}else if(M.isDataArrayTexture)if(Me){if(Ee&&t.texStorage3D(i.TEXTURE_2D_ARRAY,st,ae,oe.width,oe.height,oe.depth),je)if(M.layerUpdates.size>0){let de=xf(oe.width,oe.height,M.format,M.type);for(let He of M.layerUpdates){let nt=oe.data.subarray(He*de/oe.data.BYTES_PER_ELEMENT,(He+1)*de/oe.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,He,oe.width,oe.height,1,ye,B,nt)}M.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,oe.width,oe.height,oe.depth,ye,B,oe.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,ae,oe.width,oe.height,oe.depth,0,ye,B,oe.data);else if(M.isData3DTexture)Me?(Ee&&t.texStorage3D(i.TEXTURE_3D,st,ae,oe.width,oe.height,oe.depth),je&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,oe.width,oe.height,oe.depth,ye,B,oe.data)):t.texImage3D(i.TEXTURE_3D,0,ae,oe.width,oe.height,oe.depth,0,ye,B,oe.data);else if(M.isFramebufferTexture){if(Ee)if(Me)t.texStorage2D(i.TEXTURE_2D,st,ae,oe.width,oe.height);else{let de=oe.width,He=oe.height;for(let nt=0;nt<st;nt++)t.texImage2D(i.TEXTURE_2D,nt,ae,de,He,0,ye,B,null),de>>=1,He>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in i){let de=i.canvas;if(de.hasAttribute("layoutsubtree")||de.setAttribute("layoutsubtree","true"),oe.parentNode!==de){de.appendChild(oe),d.add(M),de.onpaint=He=>{let nt=He.changedElements;for(let Pe of d)nt.includes(Pe.image)&&(Pe.needsUpdate=!0)},de.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,oe);else{let nt=i.RGBA,Pe=i.RGBA,mt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,nt,Pe,mt,oe)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(Me&&Ee){let de=et(Ae[0]);t.texStorage2D(i.TEXTURE_2D,st,ae,de.width,de.height)}for(let de=0,He=Ae.length;de<He;de++)re=Ae[de],Me?je&&t.texSubImage2D(i.TEXTURE_2D,de,0,0,ye,B,re):t.texImage2D(i.TEXTURE_2D,de,ae,ye,B,re);M.generateMipmaps=!1}else if(Me){if(Ee){let de=et(oe);t.texStorage2D(i.TEXTURE_2D,st,ae,de.width,de.height)}je&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,ye,B,oe)}else t.texImage2D(i.TEXTURE_2D,0,ae,ye,B,oe);A(M)&&M.mipmapsAutoUpdate===!0&&S(fe),we.__version=Se.version,M.onUpdate&&M.onUpdate(M)}C.__version=M.version}function Fe(C,M,q){if(M.image.length!==6)return;let fe=ot(C,M),le=M.source;t.bindTexture(i.TEXTURE_CUBE_MAP,C.__webglTexture,i.TEXTURE0+q);let Se=n.get(le);if(le.version!==Se.__version||fe===!0){t.activeTexture(i.TEXTURE0+q);let we=Rt.getPrimaries(Rt.workingColorSpace),te=M.colorSpace===Ds?null:Rt.getPrimaries(M.colorSpace),oe=M.colorSpace===Ds||we===te?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,oe);let ye=M.isCompressedTexture||M.image[0].isCompressedTexture,B=M.image[0]&&M.image[0].isDataTexture,ae=[];for(let Pe=0;Pe<6;Pe++)!ye&&!B?ae[Pe]=y(M.image[Pe],!0,s.maxCubemapSize):ae[Pe]=B?M.image[Pe].image:M.image[Pe],ae[Pe]=Ye(M,ae[Pe]);let re=ae[0],Ae=r.convert(M.format,M.colorSpace),Me=r.convert(M.type),Ee=E(M.internalFormat,Ae,Me,M.normalized,M.colorSpace),je=M.isVideoTexture!==!0,st=Se.__version===void 0||fe===!0,de=le.dataReady,He=b(M,re);it(i.TEXTURE_CUBE_MAP,M);let nt;if(M.isDepthTexture){if(Ee=x(M.format===Ls,M.type),st)if(je)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,Ee,re.width,re.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,re.width,re.height,0,Ae,Me,null)}else if(ye){je&&st&&t.texStorage2D(i.TEXTURE_CUBE_MAP,He,Ee,re.width,re.height);for(let Pe=0;Pe<6;Pe++){nt=ae[Pe].mipmaps;for(let mt=0;mt<nt.length;mt++){let Wt=nt[mt];M.format!==Xi?Ae!==null?je?de&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,mt,0,0,Wt.width,Wt.height,Ae,Wt.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,mt,Ee,Wt.width,Wt.height,0,Wt.data):ct("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):je?de&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,mt,0,0,Wt.width,Wt.height,Ae,Me,Wt.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,mt,Ee,Wt.width,Wt.height,0,Ae,Me,Wt.data)}}}else{if(nt=M.mipmaps,je&&st){nt.length>0&&He++;let Pe=et(ae[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,He,Ee,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(B){je?de&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,ae[Pe].width,ae[Pe].height,Ae,Me,ae[Pe].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,ae[Pe].width,ae[Pe].height,0,Ae,Me,ae[Pe].data);for(let mt=0;mt<nt.length;mt++){let Cn=nt[mt].image[Pe].image;je?de&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,mt+1,0,0,Cn.width,Cn.height,Ae,Me,Cn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,mt+1,Ee,Cn.width,Cn.height,0,Ae,Me,Cn.data)}}else{je?de&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Ae,Me,ae[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,Ee,Ae,Me,ae[Pe]);for(let mt=0;mt<nt.length;mt++){let Wt=nt[mt];je?de&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,mt+1,0,0,Ae,Me,Wt.image[Pe]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,mt+1,Ee,Ae,Me,Wt.image[Pe])}}}A(M)&&M.mipmapsAutoUpdate===!0&&S(i.TEXTURE_CUBE_MAP),Se.__version=le.version,M.onUpdate&&M.onUpdate(M)}C.__version=M.version}function We(C,M,q,fe,le,Se){let we=r.convert(q.format,q.colorSpace),te=r.convert(q.type),oe=E(q.internalFormat,we,te,q.normalized,q.colorSpace),ye=n.get(M),B=n.get(q);if(B.__renderTarget=M,!ye.__hasExternalTextures){let ae=Math.max(1,M.width>>Se),re=Math.max(1,M.height>>Se);le===i.TEXTURE_3D||le===i.TEXTURE_2D_ARRAY?t.texImage3D(le,Se,oe,ae,re,M.depth,0,we,te,null):t.texImage2D(le,Se,oe,ae,re,0,we,te,null)}t.bindFramebuffer(i.FRAMEBUFFER,C),Ce(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,fe,le,B.__webglTexture,0,ft(M)):(le===i.TEXTURE_2D||le>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&le<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,fe,le,B.__webglTexture,Se),t.bindFramebuffer(i.FRAMEBUFFER,null)}function at(C,M,q){if(i.bindRenderbuffer(i.RENDERBUFFER,C),M.depthBuffer){let fe=M.depthTexture,le=fe&&fe.isDepthTexture?fe.type:null,Se=x(M.stencilBuffer,le),we=M.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Ce(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ft(M),Se,M.width,M.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ft(M),Se,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,Se,M.width,M.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,we,i.RENDERBUFFER,C)}else{let fe=M.textures;for(let le=0;le<fe.length;le++){let Se=fe[le],we=r.convert(Se.format,Se.colorSpace),te=r.convert(Se.type),oe=E(Se.internalFormat,we,te,Se.normalized,Se.colorSpace);Ce(M)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ft(M),oe,M.width,M.height):q?i.renderbufferStorageMultisample(i.RENDERBUFFER,ft(M),oe,M.width,M.height):i.renderbufferStorage(i.RENDERBUFFER,oe,M.width,M.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function ut(C,M,q){let fe=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,C),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let le=n.get(M.depthTexture);le.__renderTarget=M;let Se=fe?M.depthTexture.image[0]:M.depthTexture.image;(!le.__webglTexture||Se.width!==M.width||Se.height!==M.height)&&(Se.width=M.width,Se.height=M.height,M.depthTexture.needsUpdate=!0),fe?xe(M.depthTexture,0):ge(M.depthTexture,0);let we=le.__webglTexture,te=ft(M),oe=fe?i.TEXTURE_CUBE_MAP_POSITIVE_X+q:i.TEXTURE_2D,ye=M.depthTexture.format===Ls?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(M.depthTexture.format===Rs)Ce(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ye,oe,we,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,ye,oe,we,0);else if(M.depthTexture.format===Ls)Ce(M)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ye,oe,we,0,te):i.framebufferTexture2D(i.FRAMEBUFFER,ye,oe,we,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Kt(C){let M=n.get(C),q=C.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==C.depthTexture){let fe=C.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),fe){let le=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,fe.removeEventListener("dispose",le)};fe.addEventListener("dispose",le),M.__depthDisposeCallback=le}M.__boundDepthTexture=fe}if(C.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let fe=0;fe<6;fe++)ut(M.__webglFramebuffer[fe],C,fe);else C.texture.mipmaps.length>0?ut(M.__webglFramebuffer[0],C,0):ut(M.__webglFramebuffer,C,0);else if(q){M.__webglDepthbuffer=[];for(let fe=0;fe<6;fe++)if(t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[fe]),M.__webglDepthbuffer[fe]===void 0)M.__webglDepthbuffer[fe]=i.createRenderbuffer(),at(M.__webglDepthbuffer[fe],C,!1);else{let le=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Se=M.__webglDepthbuffer[fe];i.bindRenderbuffer(i.RENDERBUFFER,Se),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,Se)}}else if(C.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=i.createRenderbuffer(),at(M.__webglDepthbuffer,C,!1);else{let le=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Se=M.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,Se),i.framebufferRenderbuffer(i.FRAMEBUFFER,le,i.RENDERBUFFER,Se)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function Yt(C,M,q){let fe=n.get(C);M!==void 0&&We(fe.__webglFramebuffer,C,C.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),q!==void 0&&Kt(C)}function zt(C){let M=C.texture,q=n.get(C),fe=n.get(M);C.addEventListener("dispose",z),N(C);let le=C.textures,Se=C.isWebGLCubeRenderTarget===!0,we=le.length>1;if(we||(fe.__webglTexture===void 0&&(fe.__webglTexture=i.createTexture()),fe.__version=M.version,o.memory.textures++),Se){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let oe=0;oe<M.mipmaps.length;oe++)q.__webglFramebuffer[te][oe]=i.createFramebuffer()}else q.__webglFramebuffer[te]=i.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)q.__webglFramebuffer[te]=i.createFramebuffer()}else q.__webglFramebuffer=i.createFramebuffer();if(we)for(let te=0,oe=le.length;te<oe;te++){let ye=n.get(le[te]);ye.__webglTexture===void 0&&(ye.__webglTexture=i.createTexture(),o.memory.textures++)}if(C.samples>0&&Ce(C)===!1){q.__webglMultisampledFramebuffer=i.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<le.length;te++){let oe=le[te];q.__webglColorRenderbuffer[te]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let ye=r.convert(oe.format,oe.colorSpace),B=r.convert(oe.type),ae=E(oe.internalFormat,ye,B,oe.normalized,oe.colorSpace,C.isXRRenderTarget===!0),re=ft(C);i.renderbufferStorageMultisample(i.RENDERBUFFER,re,ae,C.width,C.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+te,i.RENDERBUFFER,q.__webglColorRenderbuffer[te])}i.bindRenderbuffer(i.RENDERBUFFER,null),C.depthBuffer&&(q.__webglDepthRenderbuffer=i.createRenderbuffer(),at(q.__webglDepthRenderbuffer,C,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(Se){t.bindTexture(i.TEXTURE_CUBE_MAP,fe.__webglTexture),it(i.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let oe=0;oe<M.mipmaps.length;oe++)We(q.__webglFramebuffer[te][oe],C,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,oe);else We(q.__webglFramebuffer[te],C,M,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);A(M)?S(i.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(we){for(let te=0,oe=le.length;te<oe;te++){let ye=le[te],B=n.get(ye),ae=i.TEXTURE_2D;(C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(ae=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ae,B.__webglTexture),it(ae,ye),We(q.__webglFramebuffer,C,ye,i.COLOR_ATTACHMENT0+te,ae,0),A(ye)&&S(ae)}t.unbindTexture()}else{let te=i.TEXTURE_2D;if((C.isWebGL3DRenderTarget||C.isWebGLArrayRenderTarget)&&(te=C.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(te,fe.__webglTexture),it(te,M),M.mipmaps.length>0)for(let oe=0;oe<M.mipmaps.length;oe++)We(q.__webglFramebuffer[oe],C,M,i.COLOR_ATTACHMENT0,te,oe);else We(q.__webglFramebuffer,C,M,i.COLOR_ATTACHMENT0,te,0);A(M)?S(te):M.mipmaps.length>0&&i.texParameteri(te,i.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}C.depthBuffer&&Kt(C)}function O(C){let M=C.textures;for(let q=0,fe=M.length;q<fe;q++){let le=M[q];if(A(le)&&le.mipmapsAutoUpdate===!0){let Se=P(C),we=n.get(le).__webglTexture;t.bindTexture(Se,we),S(Se),t.unbindTexture()}}}let De=[];function tt(C){if(C.samples>0){if(Ce(C)===!1){let M=C.textures,q=C.width,fe=C.height,le=i.COLOR_BUFFER_BIT,Se=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,we=n.get(C),te=M.length>1;if(te)for(let ye=0;ye<M.length;ye++)t.bindFramebuffer(i.FRAMEBUFFER,we.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ye,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,we.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ye,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,we.__webglMultisampledFramebuffer),C.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,we.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,we.__webglFramebuffer);for(let ye=0;ye<M.length;ye++){if(C.resolveDepthBuffer&&(C.depthBuffer&&(le|=i.DEPTH_BUFFER_BIT),C.stencilBuffer&&C.resolveStencilBuffer&&(le|=i.STENCIL_BUFFER_BIT)),te){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,we.__webglColorRenderbuffer[ye]);let B=n.get(M[ye]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,B,0)}i.blitFramebuffer(0,0,q,fe,0,0,q,fe,le,i.NEAREST),c===!0&&(De.length=0,De.push(i.COLOR_ATTACHMENT0+ye),C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&De.push(Se),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,De))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),te)for(let ye=0;ye<M.length;ye++){t.bindFramebuffer(i.FRAMEBUFFER,we.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ye,i.RENDERBUFFER,we.__webglColorRenderbuffer[ye]);let B=n.get(M[ye]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,we.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ye,i.TEXTURE_2D,B,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,we.__webglMultisampledFramebuffer)}else if(C.depthBuffer&&C.storeMultisampledDepthBuffer===!1&&c){let M=C.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[M])}}}function ft(C){return Math.min(s.maxSamples,C.samples)}function Ce(C){let M=n.get(C);return C.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function Pt(C){let M=o.render.frame;u.get(C)!==M&&(u.set(C,M),C.update())}function Ye(C,M){let q=C.colorSpace,fe=C.format,le=C.type;return C.isCompressedTexture===!0||C.isVideoTexture===!0||q!==Aa&&q!==Ds&&(Rt.getTransfer(q)===kt?(fe!==Xi||le!==oi)&&ct("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):dt("WebGLTextures: Unsupported texture color space:",q)),M}function et(C){return typeof HTMLImageElement<"u"&&C instanceof HTMLImageElement?(l.width=C.naturalWidth||C.width,l.height=C.naturalHeight||C.height):typeof VideoFrame<"u"&&C instanceof VideoFrame?(l.width=C.displayWidth,l.height=C.displayHeight):(l.width=C.width,l.height=C.height),l}this.allocateTextureUnit=he,this.resetTextureUnits=Y,this.getTextureUnits=ie,this.setTextureUnits=ce,this.setTexture2D=ge,this.setTexture2DArray=_e,this.setTexture3D=Te,this.setTextureCube=xe,this.rebindTextures=Yt,this.setupRenderTarget=zt,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=tt,this.setupDepthRenderbuffer=Kt,this.setupFrameBufferTexture=We,this.useMultisampledRTT=Ce,this.dispose=G}function w1(i,e){function t(n,s=Ds){let r,o=Rt.getTransfer(s);if(n===oi)return i.UNSIGNED_BYTE;if(n===Yc)return i.UNSIGNED_SHORT_4_4_4_4;if(n===$c)return i.UNSIGNED_SHORT_5_5_5_1;if(n===nf)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===sf)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===ef)return i.BYTE;if(n===tf)return i.SHORT;if(n===zo)return i.UNSIGNED_SHORT;if(n===qc)return i.INT;if(n===Vi)return i.UNSIGNED_INT;if(n===Hi)return i.FLOAT;if(n===Wi)return i.HALF_FLOAT;if(n===rf)return i.ALPHA;if(n===of)return i.RGB;if(n===Xi)return i.RGBA;if(n===Rs)return i.DEPTH_COMPONENT;if(n===Ls)return i.DEPTH_STENCIL;if(n===af)return i.RED;if(n===Zc)return i.RED_INTEGER;if(n===hr)return i.RG;if(n===Jc)return i.RG_INTEGER;if(n===Kc)return i.RGBA_INTEGER;if(n===Ja||n===Ka||n===ja||n===Qa)if(o===kt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Ja)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Ka)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===ja)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===Qa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Ja)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Ka)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===ja)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===Qa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===jc||n===Qc||n===eu||n===tu)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===jc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Qc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===eu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===tu)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===nu||n===iu||n===su||n===ru||n===ou||n===el||n===au)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===nu||n===iu)return o===kt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===su)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ru)return r.COMPRESSED_R11_EAC;if(n===ou)return r.COMPRESSED_SIGNED_R11_EAC;if(n===el)return r.COMPRESSED_RG11_EAC;if(n===au)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===lu||n===cu||n===uu||n===hu||n===du||n===fu||n===pu||n===mu||n===gu||n===xu||n===_u||n===vu||n===yu||n===bu)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===lu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===cu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===uu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===hu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===du)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===fu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===pu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===mu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===gu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===xu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===_u)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===vu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===yu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===bu)return o===kt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Mu||n===Su||n===wu)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===Mu)return o===kt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Su)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===wu)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Tu||n===Eu||n===tl||n===Au)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Tu)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Eu)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===tl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Au)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Ur?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var T1=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,E1=`
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

}`,Ef=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Ba(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new ls({vertexShader:T1,fragmentShader:E1,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Bn(new za(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Af=class extends rs{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,u=null,d=null,h=null,f=null,p=null,_=typeof XRWebGLBinding<"u",g=new Ef,m={},y=t.getContextAttributes(),A=null,S=null,P=[],E=[],x=new Tt,b=null,N=null,R=new jn;R.viewport=new un;let L=new jn;L.viewport=new un;let z=[R,L],H=new Gc,D=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let ge=P[Q];return ge===void 0&&(ge=new Io,P[Q]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(Q){let ge=P[Q];return ge===void 0&&(ge=new Io,P[Q]=ge),ge.getGripSpace()},this.getHand=function(Q){let ge=P[Q];return ge===void 0&&(ge=new Io,P[Q]=ge),ge.getHandSpace()};function k(Q){let ge=E.indexOf(Q.inputSource);if(ge===-1)return;let _e=P[ge];_e!==void 0&&(_e.update(Q.inputSource,Q.frame,l||o),_e.dispatchEvent({type:Q.type,data:Q.inputSource}))}function U(){s.removeEventListener("select",k),s.removeEventListener("selectstart",k),s.removeEventListener("selectend",k),s.removeEventListener("squeeze",k),s.removeEventListener("squeezestart",k),s.removeEventListener("squeezeend",k),s.removeEventListener("end",U),s.removeEventListener("inputsourceschange",se);for(let Q=0;Q<P.length;Q++){let ge=E[Q];ge!==null&&(E[Q]=null,P[Q].disconnect(ge))}D=null,G=null,g.reset();for(let Q in m)delete m[Q];if(e.setRenderTarget(A),f=null,h=null,d=null,s=null,S=null,he.stop(),n.isPresenting=!1,e.setPixelRatio(b),e.setSize(x.width,x.height,!1),N!==null){let Q=N.camera;Q.fov=N.fov,Q.zoom=N.zoom,Q.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&ct("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&ct("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(Q){l=Q},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return d===null&&_&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(A=e.getRenderTarget(),s.addEventListener("select",k),s.addEventListener("selectstart",k),s.addEventListener("selectend",k),s.addEventListener("squeeze",k),s.addEventListener("squeezestart",k),s.addEventListener("squeezeend",k),s.addEventListener("end",U),s.addEventListener("inputsourceschange",se),y.xrCompatible!==!0&&await t.makeXRCompatible(),b=e.getPixelRatio(),e.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Te=null,xe=null;y.depth&&(xe=y.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=y.stencil?Ls:Rs,Te=y.stencil?Ur:Vi);let Ge={colorFormat:t.RGBA8,depthFormat:xe,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(Ge),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new yi(h.textureWidth,h.textureHeight,{format:Xi,type:oi,depthTexture:new Ps(h.textureWidth,h.textureHeight,Te,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:y.stencil,colorSpace:e.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let _e={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,_e),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),S=new yi(f.framebufferWidth,f.framebufferHeight,{format:Xi,type:oi,colorSpace:e.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function se(Q){for(let ge=0;ge<Q.removed.length;ge++){let _e=Q.removed[ge],Te=E.indexOf(_e);Te>=0&&(E[Te]=null,P[Te].disconnect(_e))}for(let ge=0;ge<Q.added.length;ge++){let _e=Q.added[ge],Te=E.indexOf(_e);if(Te===-1){for(let Ge=0;Ge<P.length;Ge++)if(Ge>=E.length){E.push(_e),Te=Ge;break}else if(E[Ge]===null){E[Ge]=_e,Te=Ge;break}if(Te===-1)break}let xe=P[Te];xe&&xe.connect(_e)}}function X(Q,ge){ge===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(ge.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let ge=Q.near,_e=Q.far;g.texture!==null&&(g.depthNear>0&&(ge=g.depthNear),g.depthFar>0&&(_e=g.depthFar)),H.near=L.near=R.near=ge,H.far=L.far=R.far=_e,(D!==H.near||G!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),D=H.near,G=H.far),H.layers.mask=Q.layers.mask|6,R.layers.mask=H.layers.mask&-5,L.layers.mask=H.layers.mask&-3;let Te=Q.parent,xe=H.cameras;X(H,Te);for(let Ge=0;Ge<xe.length;Ge++)X(xe[Ge],Te);H.projectionMatrix.copy(R.projectionMatrix),H.projectionMatrixInverse.copy(R.projectionMatrixInverse),N===null&&Q.isPerspectiveCamera&&(N={camera:Q,fov:Q.fov,zoom:Q.zoom}),Y(Q,H,Te)};function Y(Q,ge,_e){_e===null?Q.matrix.copy(ge.matrixWorld):(Q.matrix.copy(_e.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(ge.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(ge.projectionMatrix),Q.projectionMatrixInverse.copy(ge.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=yc*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(h===null&&f===null))return c},this.setFoveation=function(Q){c=Q,h!==null&&(h.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(H)},this.getCameraTexture=function(Q){return m[Q]};let ie=null;function ce(Q,ge){if(u=ge.getViewerPose(l||o),p=ge,u!==null){let _e=u.views;f!==null&&(e.setRenderTargetFramebuffer(S,f.framebuffer),e.setRenderTarget(S));let Te=!1;_e.length!==H.cameras.length&&(H.cameras.length=0,Te=!0);for(let ke=0;ke<_e.length;ke++){let it=_e[ke],ot=null;if(f!==null)ot=f.getViewport(it);else{let ve=d.getViewSubImage(h,it);ot=ve.viewport,ke===0&&(e.setRenderTargetTextures(S,ve.colorTexture,ve.depthStencilTexture),e.setRenderTarget(S))}let rt=z[ke];rt===void 0&&(rt=new jn,rt.layers.enable(ke),rt.viewport=new un,z[ke]=rt),rt.matrix.fromArray(it.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(it.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ot.x,ot.y,ot.width,ot.height),ke===0&&(H.matrix.copy(rt.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Te===!0&&H.cameras.push(rt)}let xe=s.enabledFeatures;if(xe&&xe.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){d=n.getBinding();let ke=d.getDepthInformation(_e[0]);ke&&ke.isValid&&ke.texture&&g.init(ke,s.renderState)}if(xe&&xe.includes("camera-access")&&_){e.state.unbindTexture(),d=n.getBinding();for(let ke=0;ke<_e.length;ke++){let it=_e[ke].camera;if(it){let ot=m[it];ot||(ot=new Ba,m[it]=ot);let rt=d.getCameraImage(it);ot.sourceTexture=rt}}}}for(let _e=0;_e<P.length;_e++){let Te=E[_e],xe=P[_e];Te!==null&&xe!==void 0&&xe.update(Te,ge,l||o)}ie&&ie(Q,ge),ge.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:ge}),p=null}let he=new W0;he.setAnimationLoop(ce),this.setAnimationLoop=function(Q){ie=Q},this.dispose=function(){}}},A1=new ln,ex=new pt;ex.set(-1,0,0,0,1,0,0,0,1);function R1(i,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function n(g,m){m.color.getRGB(g.fogColor.value,pf(i)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,y,A,S){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),d(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),h(g,m),m.isMeshPhysicalMaterial&&f(g,m,S)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),_(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?c(g,m,y,A):m.isSpriteMaterial?l(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===ti&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===ti&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let y=e.get(m),A=y.envMap,S=y.envMapRotation;A&&(g.envMap.value=A,g.envMapRotation.value.setFromMatrix4(A1.makeRotationFromEuler(S)).transpose(),A.isCubeTexture&&A.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(ex),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function c(g,m,y,A){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*y,g.scale.value=A*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function l(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function d(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function h(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function f(g,m,y){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===ti&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=y.texture,g.transmissionSamplerSize.value.set(y.width,y.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function _(g,m){let y=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(y.matrixWorld),g.nearDistance.value=y.shadow.camera.near,g.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function C1(i,e,t,n){let s={},r={};function o(y,A){let S=A.program;n.uniformBlockBinding(y,S,s[y.id])}function a(y,A){let S=s[y.id];S===void 0&&(p(y),S=c(y),s[y.id]=S,y.addEventListener("dispose",g));let P=A.program;n.updateUBOMapping(y,P);let E=e.render.frame;r[y.id]!==E&&(l(y),r[y.id]=E)}function c(y){let A=i.createBuffer(),S=y.__size,P=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,A),i.bufferData(i.UNIFORM_BUFFER,S,P),i.bindBuffer(i.UNIFORM_BUFFER,null),A}function l(y){let A=s[y.id],S=y.uniforms,P=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,A);for(let E=0,x=S.length;E<x;E++){let b=S[E];if(Array.isArray(b))for(let N=0,R=b.length;N<R;N++)u(b[N],E,N,P);else u(b,E,0,P)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(y,A,S,P){if(h(y,A,S,P)===!0){let E=y.__offset,x=y.value;if(Array.isArray(x)){let b=0;for(let N=0;N<x.length;N++){let R=x[N],L=_(R,!0);d(R,y.__data,b),b+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else d(x,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,y.__data)}}function d(y,A,S){typeof y=="number"||typeof y=="boolean"?A[S]=y:y.isMatrix3?(A[S]=y.elements[0],A[S+1]=y.elements[1],A[S+2]=y.elements[2],A[S+3]=0,A[S+4]=y.elements[3],A[S+5]=y.elements[4],A[S+6]=y.elements[5],A[S+7]=0,A[S+8]=y.elements[6],A[S+9]=y.elements[7],A[S+10]=y.elements[8],A[S+11]=0):ArrayBuffer.isView(y)?A.set(y.subarray(0,A.length-S),S):y.toArray(A,S)}function h(y,A,S,P){let E=y.value,x=A+"_"+S;if(Array.isArray(E)){P[x]===void 0&&(P[x]=[]);let b=P[x],N=!1;for(let R=0;R<E.length;R++)f(E[R],b,R)===!0&&(N=!0);return N}return f(E,P,x)}function f(y,A,S){if(A[S]===void 0)return typeof y=="number"||typeof y=="boolean"?A[S]=y:ArrayBuffer.isView(y)?A[S]=y.slice():A[S]=y.clone(),!0;{let P=A[S];if(typeof y=="number"||typeof y=="boolean"){if(P!==y)return A[S]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(P.equals(y)===!1)return P.copy(y),!0}}return!1}function p(y){let A=y.uniforms,S=0,P=16;for(let x=0,b=A.length;x<b;x++){let N=Array.isArray(A[x])?A[x]:[A[x]];for(let R=0,L=N.length;R<L;R++){let z=N[R],H=Array.isArray(z.value)?z.value:[z.value],D=Array.isArray(A[x])||Array.isArray(z.value),G=S;for(let U=0,se=H.length;U<se;U++){let X=H[U],Y=_(X,D),ie=S%P,ce=ie%Y.boundary,he=ie+ce;S+=ce,he!==0&&P-he<Y.storage&&(S+=P-he),U===0&&(G=S),S+=Y.storage}let k=z.type==="int"?Int32Array:z.type==="uint"?Uint32Array:Float32Array;z.__data=new k((S-G)/Float32Array.BYTES_PER_ELEMENT),z.__offset=G}}let E=S%P;return E>0&&(S+=P-E),y.__size=S,y.__cache={},this}function _(y,A){let S={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(S.boundary=4,S.storage=4):y.isVector2?(S.boundary=8,S.storage=8):y.isVector3||y.isColor?(S.boundary=16,S.storage=12):y.isVector4?(S.boundary=16,S.storage=16):y.isMatrix3?(S.boundary=16,S.storage=48):y.isMatrix4?(S.boundary=16,S.storage=64):y.isTexture?ct("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(S.boundary=16,S.storage=y.byteLength):ct("WebGLRenderer: Unsupported uniform value type.",y),A===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function g(y){let A=y.target;A.removeEventListener("dispose",g),i.deleteBuffer(s[A.id]),delete s[A.id],delete r[A.id]}function m(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:m}}var P1=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),us=null;function I1(){return us===null&&(us=new Tc(P1,16,16,hr,Wi),us.name="DFG_LUT",us.minFilter=Qn,us.magFilter=Qn,us.wrapS=ss,us.wrapT=ss,us.generateMipmaps=!1,us.needsUpdate=!0),us}var Lu=class{constructor(e={}){let{canvas:t=p0(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:f=oi}=e;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let _=f,g=new Set([Kc,Jc,Zc]),m=new Set([oi,Vi,zo,Ur,Yc,$c]),y=new Uint32Array(4),A=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},P=null,E=null,x=[],b=[],N=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=cs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,L=!1,z=null,H=null,D=null,G=null;this._outputColorSpace=Kn;let k=0,U=0,se=null,X=-1,Y=null,ie=new un,ce=new un,he=null,Q=new yt(0),ge=0,_e=t.width,Te=t.height,xe=1,Ge=null,qe=null,ke=new un(0,0,_e,Te),it=new un(0,0,_e,Te),ot=!1,rt=new rr,ve=new Ec,me=!1,Fe=!1,We=new ln,at=new ee,ut=new un,Kt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Yt=!1;function zt(){return se===null?xe:1}let O=n;function De(T,V){return t.getContext(T,V)}let tt,ft,Ce,Pt,Ye,et,C,M,q,fe,le,Se,we,te,oe,ye,B,ae,re,Ae,Me,Ee,je;try{let T={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",He,!1),t.addEventListener("webglcontextrestored",nt,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),O===null){let V="webgl2";if(O=De(V,T),O===null)throw De(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}st()}catch(T){throw t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),dt("WebGLRenderer: "+T.message),T}function st(){tt=new VS(O),tt.init(),Me=new w1(O,tt),ft=new IS(O,tt,e,Me),Ce=new M1(O,tt),ft.reversedDepthBuffer&&h&&Ce.buffers.depth.setReversed(!0),H=O.createFramebuffer(),D=O.createFramebuffer(),G=O.createFramebuffer(),Pt=new XS(O),Ye=new l1,et=new S1(O,tt,Ce,Ye,ft,Me,Pt),C=new GS(R),M=new Yy(O),Ee=new CS(O,M),q=new HS(O,M,Pt,Ee),fe=new YS(O,q,M,Ee,Pt),ae=new qS(O,ft,et),oe=new LS(Ye),le=new a1(R,C,tt,ft,Ee,oe),Se=new R1(R,Ye),we=new u1,te=new g1(tt),B=new RS(R,C,Ce,fe,p,c),ye=new b1(R,fe,ft),je=new C1(O,Pt,ft,Ce),re=new PS(O,tt,Pt),Ae=new WS(O,tt,Pt),Pt.programs=le.programs,R.capabilities=ft,R.extensions=tt,R.properties=Ye,R.renderLists=we,R.shadowMap=ye,R.state=Ce,R.info=Pt}_!==oi&&(N=new ZS(_,t.width,t.height,a,s,r));let de=new Af(R,O);this.xr=de,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let T=tt.get("WEBGL_lose_context");T&&T.loseContext()},this.forceContextRestore=function(){let T=tt.get("WEBGL_lose_context");T&&T.restoreContext()},this.getPixelRatio=function(){return xe},this.setPixelRatio=function(T){T!==void 0&&(xe=T,this.setSize(_e,Te,!1))},this.getSize=function(T){return T.set(_e,Te)},this.setSize=function(T,V,ne=!0){if(de.isPresenting){ct("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=T,Te=V,t.width=Math.floor(T*xe),t.height=Math.floor(V*xe),ne===!0&&(t.style.width=T+"px",t.style.height=V+"px"),N!==null&&N.setSize(t.width,t.height),this.setViewport(0,0,T,V)},this.getDrawingBufferSize=function(T){return T.set(_e*xe,Te*xe).floor()},this.setDrawingBufferSize=function(T,V,ne){_e=T,Te=V,xe=ne,t.width=Math.floor(T*ne),t.height=Math.floor(V*ne),this.setViewport(0,0,T,V)},this.setEffects=function(T){if(_===oi){dt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(T){for(let V=0;V<T.length;V++)if(T[V].isOutputPass===!0){ct("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(T||[])},this.getCurrentViewport=function(T){return T.copy(ie)},this.getViewport=function(T){return T.copy(ke)},this.setViewport=function(T,V,ne,Z){T.isVector4?ke.set(T.x,T.y,T.z,T.w):ke.set(T,V,ne,Z),Ce.viewport(ie.copy(ke).multiplyScalar(zt()).round())},this.getScissor=function(T){return T.copy(it)},this.setScissor=function(T,V,ne,Z){T.isVector4?it.set(T.x,T.y,T.z,T.w):it.set(T,V,ne,Z),Ce.scissor(ce.copy(it).multiplyScalar(zt()).round())},this.getScissorTest=function(){return ot},this.setScissorTest=function(T){Ce.setScissorTest(ot=T)},this.setOpaqueSort=function(T){Ge=T},this.setTransparentSort=function(T){qe=T},this.getClearColor=function(T){return T.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(T=!0,V=!0,ne=!0){let Z=0;if(T){let K=!1;if(se!==null){let Ie=se.texture.format;K=g.has(Ie)}if(K){let Ie=se.texture.type,Ue=m.has(Ie),Le=B.getClearColor(),Oe=B.getClearAlpha(),Je=Le.r,ht=Le.g,bt=Le.b;Ue?(y[0]=Je,y[1]=ht,y[2]=bt,y[3]=Oe,O.clearBufferuiv(O.COLOR,0,y)):(A[0]=Je,A[1]=ht,A[2]=bt,A[3]=Oe,O.clearBufferiv(O.COLOR,0,A))}else Z|=O.COLOR_BUFFER_BIT}V&&(Z|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),ne&&(Z|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Z!==0&&O.clear(Z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(T){T.setRenderer(this),z=T},this.dispose=function(){t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),B.dispose(),we.dispose(),te.dispose(),et.dispose(),Ye.dispose(),C.dispose(),fe.dispose(),q.dispose(),Ee.dispose(),je.dispose(),le.dispose(),de.dispose(),de.removeEventListener("sessionstart",Ke),de.removeEventListener("sessionend",gt),Ft.stop()};function He(T){T.preventDefault(),df("WebGLRenderer: Context Lost."),L=!0}function nt(){df("WebGLRenderer: Context Restored."),L=!1;let T=Pt.autoReset,V=ye.enabled,ne=ye.autoUpdate,Z=ye.needsUpdate,K=ye.type;st(),Pt.autoReset=T,ye.enabled=V,ye.autoUpdate=ne,ye.needsUpdate=Z,ye.type=K}function Pe(T){dt("WebGLRenderer: A WebGL context could not be created. Reason: ",T.statusMessage)}function mt(T){let V=T.target;V.removeEventListener("dispose",mt),Wt(V)}function Wt(T){Cn(T),Ye.remove(T)}function Cn(T){let V=Ye.get(T).programs;V!==void 0&&(V.forEach(function(ne){le.releaseProgram(ne)}),T.isShaderMaterial&&le.releaseShaderCache(T))}this.renderBufferDirect=function(T,V,ne,Z,K,Ie){V===null&&(V=Kt);let Ue=K.isMesh&&K.matrixWorld.determinantAffine()<0,Le=qo(T,V,ne,Z,K);Ce.setMaterial(Z,Ue);let Oe=ne.index,Je=1;if(Z.wireframe===!0){if(Oe=q.getWireframeAttribute(ne),Oe===void 0)return;Je=2}let ht=ne.drawRange,bt=ne.attributes.position,Ze=ht.start*Je,Mt=(ht.start+ht.count)*Je;Ie!==null&&(Ze=Math.max(Ze,Ie.start*Je),Mt=Math.min(Mt,(Ie.start+Ie.count)*Je)),Oe!==null?(Ze=Math.max(Ze,0),Mt=Math.min(Mt,Oe.count)):bt!=null&&(Ze=Math.max(Ze,0),Mt=Math.min(Mt,bt.count));let hn=Mt-Ze;if(hn<0||hn===1/0)return;Ee.setup(K,Z,Le,ne,Oe);let Gt,Vt=re;if(Oe!==null&&(Gt=M.get(Oe),Vt=Ae,Vt.setIndex(Gt)),K.isMesh)Z.wireframe===!0?(Ce.setLineWidth(Z.wireframeLinewidth*zt()),Vt.setMode(O.LINES)):Vt.setMode(O.TRIANGLES);else if(K.isLine){let Sn=Z.linewidth;Sn===void 0&&(Sn=1),Ce.setLineWidth(Sn*zt()),K.isLineSegments?Vt.setMode(O.LINES):K.isLineLoop?Vt.setMode(O.LINE_LOOP):Vt.setMode(O.LINE_STRIP)}else K.isPoints?Vt.setMode(O.POINTS):K.isSprite&&Vt.setMode(O.TRIANGLES);if(K.isBatchedMesh)if(tt.get("WEBGL_multi_draw"))Vt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let Sn=K._multiDrawStarts,Xe=K._multiDrawCounts,gn=K._multiDrawCount,Et=Oe?M.get(Oe).bytesPerElement:1,ds=Ye.get(Z).currentProgram.getUniforms();for(let xn=0;xn<gn;xn++)ds.setValue(O,"_gl_DrawID",xn),Vt.render(Sn[xn]/Et,Xe[xn])}else if(K.isInstancedMesh)Vt.renderInstances(Ze,hn,K.count);else if(ne.isInstancedBufferGeometry){let Sn=ne._maxInstanceCount!==void 0?ne._maxInstanceCount:1/0,Xe=Math.min(ne.instanceCount,Sn);Vt.renderInstances(Ze,hn,Xe)}else Vt.render(Ze,hn)};function $(T,V,ne,Z){z!==null&&T.isNodeMaterial&&z.setObject(Z,T),me===!0&&oe.setState(T,ne,!1),T.transparent===!0&&T.side===Ii&&T.forceSinglePass===!1?(T.side=ti,T.needsUpdate=!0,$i(T,V,Z),T.side=ur,T.needsUpdate=!0,$i(T,V,Z),T.side=Ii):$i(T,V,Z)}this.compile=function(T,V,ne=null){ne===null&&(ne=T),z!==null&&z.renderStart(T,V,ne),E=te.get(ne),E.init(V),b.push(E),ne.traverseVisible(function(K){K.isLight&&K.layers.test(V.layers)&&(E.pushLight(K),K.castShadow&&E.pushShadow(K))}),T!==ne&&T.traverseVisible(function(K){K.isLight&&K.layers.test(V.layers)&&(E.pushLight(K),K.castShadow&&E.pushShadow(K))}),E.setupLights(),z!==null&&z.updateLights(E.state.lightsArray),Fe=this.localClippingEnabled,me=oe.init(this.clippingPlanes,Fe),me===!0&&oe.setGlobalState(this.clippingPlanes,V),z!==null&&ye.render(E.state.shadowsArray,ne,V);let Z=new Set;return T.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ie=K.material;if(Ie)if(Array.isArray(Ie))for(let Ue=0;Ue<Ie.length;Ue++){let Le=Ie[Ue];$(Le,ne,V,K),Z.add(Le)}else $(Ie,ne,V,K),Z.add(Ie)}),E=b.pop(),z!==null&&z.renderEnd(),Z},this.compileAsync=function(T,V,ne=null){let Z=this.compile(T,V,ne);return new Promise(K=>{function Ie(){if(Z.forEach(function(Ue){let Oe=Ye.get(Ue).currentProgram;(Oe===void 0||Oe.isReady())&&Z.delete(Ue)}),Z.size===0){K(T);return}setTimeout(Ie,10)}tt.get("KHR_parallel_shader_compile")!==null?Ie():setTimeout(Ie,10)})};let pe=null;function Ne(T){pe&&pe(T)}function Ke(){Ft.stop()}function gt(){Ft.start()}let Ft=new W0;Ft.setAnimationLoop(Ne),typeof self<"u"&&Ft.setContext(self),this.setAnimationLoop=function(T){pe=T,de.setAnimationLoop(T),T===null?Ft.stop():Ft.start()},de.addEventListener("sessionstart",Ke),de.addEventListener("sessionend",gt),this.render=function(T,V){if(V!==void 0&&V.isCamera!==!0){dt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;z!==null&&z.renderStart(T,V);let ne=de.enabled===!0&&de.isPresenting===!0,Z=N!==null&&(se===null||ne)&&N.begin(R,se);if(T.matrixWorldAutoUpdate===!0&&T.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),de.enabled===!0&&de.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(de.cameraAutoUpdate===!0&&de.updateCamera(V),V=de.getCamera()),T.isScene===!0&&T.onBeforeRender(R,T,V,se),E=te.get(T,b.length),E.init(V),E.state.textureUnits=et.getTextureUnits(),b.push(E),We.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?ve.setFromArrayCamera(V):rt.setFromProjectionMatrix(We,Ci,V.reversedDepth),Fe=this.localClippingEnabled,me=oe.init(this.clippingPlanes,Fe),P=we.get(T,x.length),P.init(),x.push(P),this.info.render.frame++,de.enabled===!0&&de.isPresenting===!0){let Ue=R.xr.getDepthSensingMesh();Ue!==null&&St(Ue,V,-1/0,R.sortObjects)}St(T,V,0,R.sortObjects),P.finish(),z!==null&&z.updateLights(E.state.lightsArray),R.sortObjects===!0&&P.sort(Ge,qe),Yt=de.enabled===!1||de.isPresenting===!1||de.hasDepthSensing()===!1,Yt&&B.addToRenderList(P,T),this.info.autoReset===!0&&this.info.reset(),me===!0&&oe.beginShadows();let K=E.state.shadowsArray;if(ye.render(K,T,V),me===!0&&oe.endShadows(),(Z&&N.hasRenderPass())===!1){let Ue=P.opaque,Le=P.transmissive;if(E.setupLights(),V.isArrayCamera){let Oe=V.cameras;if(Le.length>0)for(let Je=0,ht=Oe.length;Je<ht;Je++){let bt=Oe[Je];Ot(Ue,Le,T,bt)}Yt&&B.render(T);for(let Je=0,ht=Oe.length;Je<ht;Je++){let bt=Oe[Je];jt(P,T,bt,bt.viewport)}}else Le.length>0&&Ot(Ue,Le,T,V),Yt&&B.render(T),jt(P,T,V)}se!==null&&U===0&&(et.updateMultisampleRenderTarget(se),et.updateRenderTargetMipmap(se)),Z&&N.end(R),T.isScene===!0&&T.onAfterRender(R,T,V),Ee.resetDefaultState(),X=-1,Y=null,b.pop(),b.length>0?(E=b[b.length-1],et.setTextureUnits(E.state.textureUnits),me===!0&&oe.setGlobalState(R.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?P=x[x.length-1]:P=null,z!==null&&z.renderEnd()};function St(T,V,ne,Z){if(T.visible===!1)return;if(T.layers.test(V.layers)){if(T.isGroup)ne=T.renderOrder;else if(T.isLOD)T.autoUpdate===!0&&T.update(V);else if(T.isLight)E.pushLight(T),T.castShadow&&E.pushShadow(T);else if(T.isSprite){let Ue=V.isArrayCamera?ve:rt;if(!T.frustumCulled||T.intersectsFrustum(Ue)){Z&&ut.setFromMatrixPosition(T.matrixWorld).applyMatrix4(We);let Le=fe.update(T),Oe=T.material;Oe.visible&&P.push(T,Le,Oe,ne,ut.z,null,V)}}else if(T.isMesh||T.isLine||T.isPoints){let Ue=V.isArrayCamera?ve:rt;if(!T.frustumCulled||T.intersectsFrustum(Ue)){let Le=fe.update(T),Oe=T.material;if(Z&&(T.boundingSphere!==void 0?(T.boundingSphere===null&&T.computeBoundingSphere(),ut.copy(T.boundingSphere.center)):(Le.boundingSphere===null&&Le.computeBoundingSphere(),ut.copy(Le.boundingSphere.center)),ut.applyMatrix4(T.matrixWorld).applyMatrix4(We)),Array.isArray(Oe)){let Je=Le.groups;for(let ht=0,bt=Je.length;ht<bt;ht++){let Ze=Je[ht],Mt=Oe[Ze.materialIndex];Mt&&Mt.visible&&P.push(T,Le,Mt,ne,ut.z,Ze,V)}}else Oe.visible&&P.push(T,Le,Oe,ne,ut.z,null,V)}}}let Ie=T.children;for(let Ue=0,Le=Ie.length;Ue<Le;Ue++)St(Ie[Ue],V,ne,Z)}function jt(T,V,ne,Z){let{opaque:K,transmissive:Ie,transparent:Ue}=T;E.setupLightsView(ne),me===!0&&oe.setGlobalState(R.clippingPlanes,ne),Z&&Ce.viewport(ie.copy(Z)),K.length>0&&It(K,V,ne),Ie.length>0&&It(Ie,V,ne),Ue.length>0&&It(Ue,V,ne),Ce.buffers.depth.setTest(!0),Ce.buffers.depth.setMask(!0),Ce.buffers.color.setMask(!0),Ce.setPolygonOffset(!1)}function Ot(T,V,ne,Z){if((ne.isScene===!0?ne.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Z.id]===void 0){let Ze=tt.has("EXT_color_buffer_half_float")||tt.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Z.id]=new yi(1,1,{generateMipmaps:!0,type:Ze?Wi:oi,minFilter:Is,samples:Math.max(4,ft.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Rt.workingColorSpace})}let Ie=E.state.transmissionRenderTarget[Z.id],Ue=Z.viewport||ie;Ie.setSize(Ue.z*R.transmissionResolutionScale,Ue.w*R.transmissionResolutionScale);let Le=R.getRenderTarget(),Oe=R.getActiveCubeFace(),Je=R.getActiveMipmapLevel();R.setRenderTarget(Ie),R.getClearColor(Q),ge=R.getClearAlpha(),ge<1&&R.setClearColor(16777215,.5),R.clear(),Yt&&B.render(ne);let ht=R.toneMapping;R.toneMapping=cs;let bt=Z.viewport;if(Z.viewport!==void 0&&(Z.viewport=void 0),E.setupLightsView(Z),me===!0&&oe.setGlobalState(R.clippingPlanes,Z),It(T,ne,Z),et.updateMultisampleRenderTarget(Ie),et.updateRenderTargetMipmap(Ie),tt.has("WEBGL_multisampled_render_to_texture")===!1){let Ze=!1;for(let Mt=0,hn=V.length;Mt<hn;Mt++){let Gt=V[Mt],{object:Vt,geometry:Sn,material:Xe,group:gn}=Gt;if(Xe.side===Ii&&Vt.layers.test(Z.layers)){let Et=Xe.side;Xe.side=ti,Xe.needsUpdate=!0,Xt(Vt,ne,Z,Sn,Xe,gn),Xe.side=Et,Xe.needsUpdate=!0,Ze=!0}}Ze===!0&&(et.updateMultisampleRenderTarget(Ie),et.updateRenderTargetMipmap(Ie))}R.setRenderTarget(Le,Oe,Je),R.setClearColor(Q,ge),bt!==void 0&&(Z.viewport=bt),R.toneMapping=ht}function It(T,V,ne){let Z=V.isScene===!0?V.overrideMaterial:null;for(let K=0,Ie=T.length;K<Ie;K++){let Ue=T[K],{object:Le,geometry:Oe,group:Je}=Ue,ht=Ue.material;ht.allowOverride===!0&&Z!==null&&(ht=Z),Le.layers.test(ne.layers)&&Xt(Le,V,ne,Oe,ht,Je)}}function Xt(T,V,ne,Z,K,Ie){z!==null&&K.isNodeMaterial&&z.setObject(T,K),T.onBeforeRender(R,V,ne,Z,K,Ie),T.modelViewMatrix.multiplyMatrices(ne.matrixWorldInverse,T.matrixWorld),T.normalMatrix.getNormalMatrix(T.modelViewMatrix),K.onBeforeRender(R,V,ne,Z,T,Ie),K.transparent===!0&&K.side===Ii&&K.forceSinglePass===!1?(K.side=ti,K.needsUpdate=!0,R.renderBufferDirect(ne,V,Z,K,T,Ie),K.side=ur,K.needsUpdate=!0,R.renderBufferDirect(ne,V,Z,K,T,Ie),K.side=Ii):R.renderBufferDirect(ne,V,Z,K,T,Ie),T.onAfterRender(R,V,ne,Z,K,Ie)}function rn(T){let V=0;for(let ne of T)ne.texture!==null&&V++;return V}function $i(T,V,ne){V.isScene!==!0&&(V=Kt);let Z=Ye.get(T),K=E.state.lights,Ie=E.state.shadowsArray,Ue=K.state.version,Le=le.getParameters(T,K.state,Ie,V,ne,E.state.lightProbeGridArray),Oe=le.getProgramCacheKey(Le),Je=Z.programs;Z.environment=T.isMeshStandardMaterial||T.isMeshLambertMaterial||T.isMeshPhongMaterial?V.environment:null,Z.fog=V.fog;let ht=T.isMeshStandardMaterial||T.isMeshLambertMaterial&&!T.envMap||T.isMeshPhongMaterial&&!T.envMap;Z.envMap=C.get(T.envMap||Z.environment,ht),Z.envMapRotation=Z.environment!==null&&T.envMap===null?V.environmentRotation:T.envMapRotation,Je===void 0&&(T.addEventListener("dispose",mt),Je=new Map,Z.programs=Je,Z.programVariants=new Map);let bt=Je.get(Oe);if(bt!==void 0){if(Z.currentProgram===bt&&Z.lightsStateVersion===Ue)return Xo(T,Le),bt}else Le.uniforms=le.getUniforms(T),z!==null&&T.isNodeMaterial&&z.build(T,ne,Le),T.onBeforeCompile(Le,R),bt=le.acquireProgram(Le,Oe),Je.set(Oe,bt),Z.uniforms=Le.uniforms;let Ze=Z.uniforms;return(!T.isShaderMaterial&&!T.isRawShaderMaterial||T.clipping===!0)&&(Ze.clippingPlanes=oe.uniform),Xo(T,Le),Z.needsLights=Fs(T),Z.lightsStateVersion=Ue,Z.needsLights&&(Ze.ambientLightColor.value=K.state.ambient,Ze.lightProbe.value=K.state.probe,Ze.sunLights.value=K.state.sun,Ze.sunLightShadows.value=K.state.sunShadow,Ze.directionalLights.value=K.state.directional,Ze.directionalLightShadows.value=K.state.directionalShadow,Ze.spotLights.value=K.state.spot,Ze.spotLightShadows.value=K.state.spotShadow,Ze.rectAreaLights.value=K.state.rectArea,Ze.ltc_1.value=K.state.rectAreaLTC1,Ze.ltc_2.value=K.state.rectAreaLTC2,Ze.pointLights.value=K.state.point,Ze.pointLightShadows.value=K.state.pointShadow,Ze.hemisphereLights.value=K.state.hemi,Ze.sunShadowMatrix.value=K.state.sunShadowMatrix,Ze.sunShadowCascade.value=K.state.sunShadowCascade,Ze.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Ze.spotLightMatrix.value=K.state.spotLightMatrix,Ze.spotLightMap.value=K.state.spotLightMap,Ze.pointShadowMatrix.value=K.state.pointShadowMatrix),Z.numLightProbeGrids=rn(E.state.lightProbeGridArray),Z.currentProgram=bt,Z.uniformsList=null,bt}function ai(T,V,ne,Z,K){let Ie=Ye.get(T),Ue=Ie.currentProgram.id+","+Z+","+K,Le=Ie.programVariants.get(Ue);return Le===void 0?(Le=$i(T,V,ne),Ie.programVariants.set(Ue,Le)):(Ie.currentProgram=Le,Ie.uniformsList=null,Ie.outputColorSpace=Z,Ie.toneMapping=K),Le}function Us(T){if(T.uniformsList===null){let V=T.currentProgram.getUniforms();T.uniformsList=Go.seqWithValue(V.seq,T.uniforms)}return T.uniformsList}function Xo(T,V){let ne=Ye.get(T);ne.outputColorSpace=V.outputColorSpace,ne.batching=V.batching,ne.batchingColor=V.batchingColor,ne.instancing=V.instancing,ne.instancingColor=V.instancingColor,ne.instancingMorph=V.instancingMorph,ne.skinning=V.skinning,ne.morphTargets=V.morphTargets,ne.morphNormals=V.morphNormals,ne.morphColors=V.morphColors,ne.morphTargetsCount=V.morphTargetsCount,ne.numClippingPlanes=V.numClippingPlanes,ne.numIntersection=V.numClipIntersection,ne.vertexAlphas=V.vertexAlphas,ne.vertexTangents=V.vertexTangents,ne.toneMapping=V.toneMapping}function qo(T,V,ne,Z,K){V.isScene!==!0&&(V=Kt),et.resetTextureUnits();let Ie=V.fog,Ue=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial?V.environment:null,Le=se===null?R.outputColorSpace:se.isXRRenderTarget===!0?se.texture.colorSpace:Rt.workingColorSpace,Oe=Z.isMeshStandardMaterial||Z.isMeshLambertMaterial&&!Z.envMap||Z.isMeshPhongMaterial&&!Z.envMap,Je=C.get(Z.envMap||Ue,Oe),ht=Z.vertexColors===!0&&!!ne.attributes.color&&ne.attributes.color.itemSize===4,bt=!!ne.attributes.tangent&&(!!Z.normalMap||Z.anisotropy>0),Ze=!!ne.morphAttributes.position,Mt=!!ne.morphAttributes.normal,hn=!!ne.morphAttributes.color,Gt=cs;Z.toneMapped&&(se===null||se.isXRRenderTarget===!0)&&(Gt=R.toneMapping);let Vt=ne.morphAttributes.position||ne.morphAttributes.normal||ne.morphAttributes.color,Sn=Vt!==void 0?Vt.length:0,Xe=Ye.get(Z),gn=E.state.lights;if(me===!0&&(Fe===!0||T!==Y)){let Ht=T===Y&&Z.id===X;oe.setState(Z,T,Ht)}let Et=!1,ds=!1;Z.version===Xe.__version?Xe.needsLights&&Xe.lightsStateVersion!==gn.state.version||K.isBatchedMesh&&Xe.batching===!1||!K.isBatchedMesh&&Xe.batching===!0||K.isBatchedMesh&&Xe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Xe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Xe.instancing===!1||!K.isInstancedMesh&&Xe.instancing===!0||K.isSkinnedMesh&&Xe.skinning===!1||!K.isSkinnedMesh&&Xe.skinning===!0||K.isInstancedMesh&&Xe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Xe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Xe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Xe.instancingMorph===!1&&K.morphTexture!==null||Xe.envMap!==Je||Z.fog===!0&&Xe.fog!==Ie||Xe.numClippingPlanes!==void 0&&(Xe.numClippingPlanes!==oe.numPlanes||Xe.numIntersection!==oe.numIntersection)||Xe.vertexAlphas!==ht||Xe.vertexTangents!==bt||Xe.morphTargets!==Ze||Xe.morphNormals!==Mt||Xe.morphColors!==hn||Xe.morphTargetsCount!==Sn||Xe.numLightProbeGrids!==rn(E.state.lightProbeGridArray)?Et=!0:(Xe.outputColorSpace!==Le||Xe.toneMapping!==Gt)&&(ds=!0):(Et=!0,Xe.__version=Z.version);let xn=Xe.currentProgram;(Et===!0||ds===!0)&&(xn=ds===!0?ai(Z,V,K,Le,Gt):$i(Z,V,K),z&&Z.isNodeMaterial&&z.onUpdateProgram(Z,xn,Xe));let zr=!1,Zi=!1,fs=!1,_t=xn.getUniforms(),dn=Xe.uniforms;if(Ce.useProgram(xn.program)&&(zr=!0,Zi=!0,fs=!0),Z.id!==X&&(X=Z.id,Zi=!0),zr||Y!==T){Ce.buffers.depth.getReversed()&&T.reversedDepth!==!0&&(T._reversedDepth=!0,T.updateProjectionMatrix()),_t.setValue(O,"projectionMatrix",T.projectionMatrix),_t.setValue(O,"viewMatrix",T.matrixWorldInverse);let _n=_t.map.cameraPosition;_n!==void 0&&_n.setValue(O,at.setFromMatrixPosition(T.matrixWorld)),ft.logarithmicDepthBuffer&&_t.setValue(O,"logDepthBufFC",2/(Math.log(T.far+1)/Math.LN2)),(Z.isMeshPhongMaterial||Z.isMeshToonMaterial||Z.isMeshLambertMaterial||Z.isMeshBasicMaterial||Z.isMeshStandardMaterial||Z.isShaderMaterial)&&_t.setValue(O,"isOrthographic",T.isOrthographicCamera===!0),Y!==T&&(Y=T,Zi=!0,fs=!0)}if(Xe.needsLights&&(gn.state.sunShadowMap.length>0&&_t.setValue(O,"sunShadowMap",gn.state.sunShadowMap,et),gn.state.directionalShadowMap.length>0&&_t.setValue(O,"directionalShadowMap",gn.state.directionalShadowMap,et),gn.state.spotShadowMap.length>0&&_t.setValue(O,"spotShadowMap",gn.state.spotShadowMap,et),gn.state.pointShadowMap.length>0&&_t.setValue(O,"pointShadowMap",gn.state.pointShadowMap,et)),K.isSkinnedMesh){_t.setOptional(O,K,"bindMatrix"),_t.setOptional(O,K,"bindMatrixInverse");let Ht=K.skeleton;Ht&&(Ht.boneTexture===null&&Ht.computeBoneTexture(),_t.setValue(O,"boneTexture",Ht.boneTexture,et))}K.isBatchedMesh&&(_t.setOptional(O,K,"batchingTexture"),_t.setValue(O,"batchingTexture",K._matricesTexture,et),_t.setOptional(O,K,"batchingIdTexture"),_t.setValue(O,"batchingIdTexture",K._indirectTexture,et),_t.setOptional(O,K,"batchingColorTexture"),K._colorsTexture!==null&&_t.setValue(O,"batchingColorTexture",K._colorsTexture,et));let qn=ne.morphAttributes;if((qn.position!==void 0||qn.normal!==void 0||qn.color!==void 0)&&ae.update(K,ne,xn),(Zi||Xe.receiveShadow!==K.receiveShadow)&&(Xe.receiveShadow=K.receiveShadow,_t.setValue(O,"receiveShadow",K.receiveShadow)),(Z.isMeshStandardMaterial||Z.isMeshLambertMaterial||Z.isMeshPhongMaterial)&&Z.envMap===null&&V.environment!==null&&(dn.envMapIntensity.value=V.environmentIntensity),dn.dfgLUT!==void 0&&(dn.dfgLUT.value=I1()),Zi){if(_t.setValue(O,"toneMappingExposure",R.toneMappingExposure),Xe.needsLights&&Br(dn,fs),Ie&&Z.fog===!0&&Se.refreshFogUniforms(dn,Ie),Se.refreshMaterialUniforms(dn,Z,xe,Te,E.state.transmissionRenderTarget[T.id]),Xe.needsLights&&Xe.numLightProbeGrids>0){let Ht=S,_n=0;for(let Gn of E.state.lightProbeGridArray)Gn.texture!==null&&(Ht.textures[_n]=Gn.texture,Ht.min[_n]=Gn.boundingBox.min,Ht.max[_n]=Gn.boundingBox.max,Ht.resolution[_n]=Gn.resolution,_n++);for(let Gn in Ht)Ht[Gn].length=_n;dn.probesSH.value=Ht.textures,dn.probesMin.value=Ht.min,dn.probesMax.value=Ht.max,dn.probesResolution.value=Ht.resolution}Go.upload(O,Us(Xe),dn,et)}if(Z.isShaderMaterial&&Z.uniformsNeedUpdate===!0&&(Go.upload(O,Us(Xe),dn,et),Z.uniformsNeedUpdate=!1),Z.isSpriteMaterial&&_t.setValue(O,"center",K.center),_t.setValue(O,"modelViewMatrix",K.modelViewMatrix),_t.setValue(O,"normalMatrix",K.normalMatrix),_t.setValue(O,"modelMatrix",K.matrixWorld),Z.uniformsGroups!==void 0){let Ht=Z.uniformsGroups;for(let _n=0,Gn=Ht.length;_n<Gn;_n++){let hl=Ht[_n];je.update(hl,xn),je.bind(hl,xn)}}return xn}function Br(T,V){T.ambientLightColor.needsUpdate=V,T.lightProbe.needsUpdate=V,T.sunLights.needsUpdate=V,T.sunLightShadows.needsUpdate=V,T.directionalLights.needsUpdate=V,T.directionalLightShadows.needsUpdate=V,T.pointLights.needsUpdate=V,T.pointLightShadows.needsUpdate=V,T.spotLights.needsUpdate=V,T.spotLightShadows.needsUpdate=V,T.rectAreaLights.needsUpdate=V,T.hemisphereLights.needsUpdate=V}function Fs(T){return T.isMeshLambertMaterial||T.isMeshToonMaterial||T.isMeshPhongMaterial||T.isMeshStandardMaterial||T.isShadowMaterial||T.isShaderMaterial&&T.lights===!0}this.getActiveCubeFace=function(){return k},this.getActiveMipmapLevel=function(){return U},this.getRenderTarget=function(){return se},this.setRenderTargetTextures=function(T,V,ne){let Z=Ye.get(T);Z.__autoAllocateDepthBuffer=T.resolveDepthBuffer===!1,Z.__autoAllocateDepthBuffer===!1&&(Z.__useRenderToTexture=!1),Ye.get(T.texture).__webglTexture=V,Ye.get(T.depthTexture).__webglTexture=Z.__autoAllocateDepthBuffer?void 0:ne,Z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(T,V){let ne=Ye.get(T);ne.__webglFramebuffer=V,ne.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(T,V=0,ne=0){se=T,k=V,U=ne;let Z=null,K=!1,Ie=!1;if(T){let Le=Ye.get(T);if(Le.__useDefaultFramebuffer!==void 0){Ce.bindFramebuffer(O.FRAMEBUFFER,Le.__webglFramebuffer),ie.copy(T.viewport),ce.copy(T.scissor),he=T.scissorTest,Ce.viewport(ie),Ce.scissor(ce),Ce.setScissorTest(he),X=-1;return}else if(Le.__webglFramebuffer===void 0)et.setupRenderTarget(T);else if(Le.__hasExternalTextures)et.rebindTextures(T,Ye.get(T.texture).__webglTexture,Ye.get(T.depthTexture).__webglTexture);else if(T.depthBuffer){let ht=T.depthTexture;if(Le.__boundDepthTexture!==ht){if(ht!==null&&Ye.has(ht)&&(T.width!==ht.image.width||T.height!==ht.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");et.setupDepthRenderbuffer(T)}}let Oe=T.texture;(Oe.isData3DTexture||Oe.isDataArrayTexture||Oe.isCompressedArrayTexture)&&(Ie=!0);let Je=Ye.get(T).__webglFramebuffer;T.isWebGLCubeRenderTarget?(Array.isArray(Je[V])?Z=Je[V][ne]:Z=Je[V],K=!0):T.samples>0&&et.useMultisampledRTT(T)===!1?Z=Ye.get(T).__webglMultisampledFramebuffer:Array.isArray(Je)?Z=Je[ne]:Z=Je,ie.copy(T.viewport),ce.copy(T.scissor),he=T.scissorTest}else ie.copy(ke).multiplyScalar(xe).floor(),ce.copy(it).multiplyScalar(xe).floor(),he=ot;if(ne!==0&&(Z=H),Ce.bindFramebuffer(O.FRAMEBUFFER,Z)&&Ce.drawBuffers(T,Z),Ce.viewport(ie),Ce.scissor(ce),Ce.setScissorTest(he),K){let Le=Ye.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+V,Le.__webglTexture,ne)}else if(Ie){let Le=V;for(let Oe=0;Oe<T.textures.length;Oe++){let Je=Ye.get(T.textures[Oe]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Oe,Je.__webglTexture,ne,Le)}}else if(T!==null&&ne!==0){let Le=Ye.get(T.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Le.__webglTexture,ne)}X=-1};function kr(T){let V=Ye.get(T);return(V.__readFormat!==T.format||V.__readType!==T.type)&&(V.__readFormat=T.format,V.__readType=T.type,V.__formatReadable=ft.textureFormatReadable(T.format),V.__typeReadable=ft.textureTypeReadable(T.type)),V}this.readRenderTargetPixels=function(T,V,ne,Z,K,Ie,Ue,Le=0){if(!(T&&T.isWebGLRenderTarget)){dt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Oe=Ye.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ue!==void 0&&(Oe=Oe[Ue],Array.isArray(Oe)&&(Oe=Oe[0])),Oe){Ce.bindFramebuffer(O.FRAMEBUFFER,Oe);try{let Je=T.textures[Le],ht=Je.format,bt=Je.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Le);let Ze=kr(Je);if(Ze.__formatReadable===!1){dt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ze.__typeReadable===!1){dt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=T.width-Z&&ne>=0&&ne<=T.height-K&&O.readPixels(V,ne,Z,K,Me.convert(ht),Me.convert(bt),Ie)}finally{let Je=se!==null?Ye.get(se).__webglFramebuffer:null;Ce.bindFramebuffer(O.FRAMEBUFFER,Je)}}},this.readRenderTargetPixelsAsync=async function(T,V,ne,Z,K,Ie,Ue,Le=0){if(!(T&&T.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Oe=Ye.get(T).__webglFramebuffer;if(T.isWebGLCubeRenderTarget&&Ue!==void 0&&(Oe=Oe[Ue],Array.isArray(Oe)&&(Oe=Oe[0])),Oe)if(V>=0&&V<=T.width-Z&&ne>=0&&ne<=T.height-K){Ce.bindFramebuffer(O.FRAMEBUFFER,Oe);let Je=T.textures[Le],ht=Je.format,bt=Je.type;T.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Le);let Ze=kr(Je);if(Ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Mt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,Mt),O.bufferData(O.PIXEL_PACK_BUFFER,Ie.byteLength,O.STREAM_READ),O.readPixels(V,ne,Z,K,Me.convert(ht),Me.convert(bt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let hn=se!==null?Ye.get(se).__webglFramebuffer:null;Ce.bindFramebuffer(O.FRAMEBUFFER,hn);let Gt=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await g0(O,Gt,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,Mt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Ie),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(Mt),O.deleteSync(Gt),Ie}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(T,V=null,ne=0){let Z=Math.pow(2,-ne),K=Math.floor(T.image.width*Z),Ie=Math.floor(T.image.height*Z),Ue=V!==null?V.x:0,Le=V!==null?V.y:0;et.setTexture2D(T,0),O.copyTexSubImage2D(O.TEXTURE_2D,ne,0,0,Ue,Le,K,Ie),Ce.unbindTexture()},this.copyTextureToTexture=function(T,V,ne=null,Z=null,K=0,Ie=0){let Ue,Le,Oe,Je,ht,bt,Ze,Mt,hn,Gt=T.isCompressedTexture?T.mipmaps[Ie]:T.image;if(ne!==null)Ue=ne.max.x-ne.min.x,Le=ne.max.y-ne.min.y,Oe=ne.isBox3?ne.max.z-ne.min.z:1,Je=ne.min.x,ht=ne.min.y,bt=ne.isBox3?ne.min.z:0;else{let _t=Math.pow(2,-K);Ue=Math.floor(Gt.width*_t),Le=Math.floor(Gt.height*_t),T.isDataArrayTexture?Oe=Gt.depth:T.isData3DTexture?Oe=Math.floor(Gt.depth*_t):Oe=1,Je=0,ht=0,bt=0}Z!==null?(Ze=Z.x,Mt=Z.y,hn=Z.z):(Ze=0,Mt=0,hn=0);let Vt=Me.convert(V.format),Sn=Me.convert(V.type),Xe;V.isData3DTexture?(et.setTexture3D(V,0),Xe=O.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(et.setTexture2DArray(V,0),Xe=O.TEXTURE_2D_ARRAY):(et.setTexture2D(V,0),Xe=O.TEXTURE_2D),Ce.activeTexture(O.TEXTURE0),Ce.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,V.flipY),Ce.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),Ce.pixelStorei(O.UNPACK_ALIGNMENT,V.unpackAlignment);let gn=Ce.getParameter(O.UNPACK_ROW_LENGTH),Et=Ce.getParameter(O.UNPACK_IMAGE_HEIGHT),ds=Ce.getParameter(O.UNPACK_SKIP_PIXELS),xn=Ce.getParameter(O.UNPACK_SKIP_ROWS),zr=Ce.getParameter(O.UNPACK_SKIP_IMAGES);Ce.pixelStorei(O.UNPACK_ROW_LENGTH,Gt.width),Ce.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Gt.height),Ce.pixelStorei(O.UNPACK_SKIP_PIXELS,Je),Ce.pixelStorei(O.UNPACK_SKIP_ROWS,ht),Ce.pixelStorei(O.UNPACK_SKIP_IMAGES,bt);let Zi=T.isDataArrayTexture||T.isData3DTexture,fs=V.isDataArrayTexture||V.isData3DTexture;if(T.isDepthTexture){let _t=Ye.get(T),dn=Ye.get(V),qn=Ye.get(_t.__renderTarget),Ht=Ye.get(dn.__renderTarget);Ce.bindFramebuffer(O.READ_FRAMEBUFFER,qn.__webglFramebuffer),Ce.bindFramebuffer(O.DRAW_FRAMEBUFFER,Ht.__webglFramebuffer);for(let _n=0;_n<Oe;_n++)Zi&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ye.get(T).__webglTexture,K,bt+_n),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ye.get(V).__webglTexture,Ie,hn+_n)),O.blitFramebuffer(Je,ht,Je+Ue,ht+Le,Ze,Mt,Ze+Ue,Mt+Le,O.DEPTH_BUFFER_BIT,O.NEAREST);Ce.bindFramebuffer(O.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(K!==0||T.isRenderTargetTexture||Ye.has(T)){let _t=Ye.get(T),dn=Ye.get(V);Ce.bindFramebuffer(O.READ_FRAMEBUFFER,D),Ce.bindFramebuffer(O.DRAW_FRAMEBUFFER,G);for(let qn=0;qn<Oe;qn++)Zi?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,_t.__webglTexture,K,bt+qn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,_t.__webglTexture,K),fs?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,dn.__webglTexture,Ie,hn+qn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,dn.__webglTexture,Ie),K!==0?O.blitFramebuffer(Je,ht,Je+Ue,ht+Le,Ze,Mt,Ze+Ue,Mt+Le,O.COLOR_BUFFER_BIT,O.NEAREST):fs?O.copyTexSubImage3D(Xe,Ie,Ze,Mt,hn+qn,Je,ht,Ue,Le):O.copyTexSubImage2D(Xe,Ie,Ze,Mt,Je,ht,Ue,Le);Ce.bindFramebuffer(O.READ_FRAMEBUFFER,null),Ce.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else fs?T.isDataTexture||T.isData3DTexture?O.texSubImage3D(Xe,Ie,Ze,Mt,hn,Ue,Le,Oe,Vt,Sn,Gt.data):V.isCompressedArrayTexture?O.compressedTexSubImage3D(Xe,Ie,Ze,Mt,hn,Ue,Le,Oe,Vt,Gt.data):O.texSubImage3D(Xe,Ie,Ze,Mt,hn,Ue,Le,Oe,Vt,Sn,Gt):T.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Ie,Ze,Mt,Ue,Le,Vt,Sn,Gt.data):T.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Ie,Ze,Mt,Gt.width,Gt.height,Vt,Gt.data):O.texSubImage2D(O.TEXTURE_2D,Ie,Ze,Mt,Ue,Le,Vt,Sn,Gt);Ce.pixelStorei(O.UNPACK_ROW_LENGTH,gn),Ce.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Et),Ce.pixelStorei(O.UNPACK_SKIP_PIXELS,ds),Ce.pixelStorei(O.UNPACK_SKIP_ROWS,xn),Ce.pixelStorei(O.UNPACK_SKIP_IMAGES,zr),Ie===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&O.generateMipmap(Xe),Ce.unbindTexture()},this.initRenderTarget=function(T){Ye.get(T).__webglFramebuffer===void 0&&et.setupRenderTarget(T)},this.initTexture=function(T){T.isCubeTexture?et.setTextureCube(T,0):T.isData3DTexture?et.setTexture3D(T,0):T.isDataArrayTexture||T.isCompressedArrayTexture?et.setTexture2DArray(T,0):et.setTexture2D(T,0),Ce.unbindTexture()},this.resetState=function(){k=0,U=0,se=null,Ce.reset(),Ee.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ci}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=Rt._getDrawingBufferColorSpace(e),t.unpackColorSpace=Rt._getUnpackColorSpace()}};function nx(i,e=!1){let t=i[0].index!==null,n=new Set(Object.keys(i[0].attributes)),s=new Set(Object.keys(i[0].morphAttributes)),r={},o={},a=i[0].morphTargetsRelative,c=new bi;c.morphTargetsRelative=a;let l=0;for(let u=0;u<i.length;++u){let d=i[u],h=0,f=0;if(t!==(d.index!==null))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". All geometries must have compatible attributes; make sure index attribute exists among all geometries, or in none of them."),null;for(let p in d.attributes){if(!n.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have compatible attributes; make sure "'+p+'" attribute exists among all geometries, or in none of them.'),null;r[p]===void 0&&(r[p]=[]),r[p].push(d.attributes[p]),h++}if(h!==n.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of attributes."),null;if(a!==d.morphTargetsRelative)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". .morphTargetsRelative must be consistent throughout all geometries."),null;for(let p in d.morphAttributes){if(!s.has(p))return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+".  .morphAttributes must be consistent throughout all geometries."),null;if(d.morphAttributes[p].length!==i[0].morphAttributes[p].length)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+'. All geometries must have the same number of morph targets for the "'+p+'" morph attribute.'),null;o[p]===void 0&&(o[p]=[]),o[p].push(d.morphAttributes[p]),f++}if(f!==s.size)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". Make sure all geometries have the same number of morph attributes."),null;if(e){let p;if(t)p=d.index.count;else if(d.attributes.position!==void 0)p=d.attributes.position.count;else return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed with geometry at index "+u+". The geometry must have either an index or a position attribute"),null;c.addGroup(l,p,u),l+=p}}if(t){let u=0,d=[];for(let h=0;h<i.length;++h){let f=i[h].index;for(let p=0;p<f.count;++p)d.push(f.getX(p)+u);u+=i[h].attributes.position.count}c.setIndex(d)}for(let u in r){let d=tx(r[u]);if(!d)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" attribute."),null;c.setAttribute(u,d)}for(let u in o){let d=o[u][0].length;if(d!==0){c.morphAttributes=c.morphAttributes||{},c.morphAttributes[u]=[];for(let h=0;h<d;++h){let f=[];for(let _=0;_<o[u].length;++_)f.push(o[u][_][h]);let p=tx(f);if(!p)return console.error("THREE.BufferGeometryUtils: .mergeGeometries() failed while trying to merge the "+u+" morphAttribute."),null;c.morphAttributes[u].push(p)}}}return c}function tx(i){let e,t,n,s=-1,r=0;for(let l=0;l<i.length;++l){let u=i[l];if(e===void 0&&(e=u.array.constructor),e!==u.array.constructor)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.array must be of consistent array types across matching attributes."),null;if(t===void 0&&(t=u.itemSize),t!==u.itemSize)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.itemSize must be consistent across matching attributes."),null;if(n===void 0&&(n=u.normalized),n!==u.normalized)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.normalized must be consistent across matching attributes."),null;if(s===-1&&(s=u.gpuType),s!==u.gpuType)return console.error("THREE.BufferGeometryUtils: .mergeAttributes() failed. BufferAttribute.gpuType must be consistent across matching attributes."),null;r+=u.count*t}let o=new e(r),a=new Pi(o,t,n),c=0;for(let l=0;l<i.length;++l){let u=i[l];if(u.isInterleavedBufferAttribute){let d=c/t;for(let h=0,f=u.count;h<f;h++)for(let p=0;p<t;p++){let _=u.getComponent(h,p);a.setComponent(h+d,p,_)}}else o.set(u.array,c);c+=u.count*t}return s!==void 0&&(a.gpuType=s),a}var al=-.7,ix=-.23,rx=[.25,-.4,2.4],sx=1,Cf=.1,L1=.62,D1=4,N1=46,Ho="#8f9aa8",Ns="#39424e",U1="#b08d57",Pf=class{constructor(e,t,n){this.canvas=e;this.renderer=new Lu({canvas:e,antialias:!0,alpha:!0}),this.renderer.setScissorTest(!0),this.accent=new Uo,this.arrows=new as;let s=new Ya("#ffffff",2.4);s.position.set(...rx),this.scene.add(new Wa("#ffffff","#aab4c2",1.9),s,this.floor,F1()),this.setRig(t,n),this.camera.up.set(0,0,1),this.orbitByDragging(),this.orbitByKeys(),this.paint(),Gs(()=>this.paint())}canvas;renderer;scene=new La;camera=new jn(30,1,.1,20);body;ghost;shadow;rig=null;parameters;floor=k1();shade=new as;haze=new as({transparent:!0,opacity:.25,depthWrite:!1});accent;arrows;fits=!1;places=new Map;resized=new ResizeObserver(()=>{ml()||(this.places.clear(),this.fits=!1,this.moved=!0)});centres=new Map;centre=new ee;spins=new Map;moved=!0;azimuth=-.62;height=.42;setRig(e,t){if(this.parameters=t,e===this.rig)return;this.rig=e;let n=this.body?[this.body.travel,this.ghost.travel,this.shadow.travel.parent]:[];for(let s of n)this.scene.remove(s),s.traverse(r=>r instanceof Bn&&r.geometry.dispose());this.body=O1(e,this.accent,this.arrows),this.ghost=cx(e,this.haze),this.shadow=B1(e,this.shade),this.scene.add(this.body.travel,this.ghost.travel,this.shadow.travel.parent),this.moved=!0}paint(){this.floor.material.color.set(hi("floor")),this.shade.color.set(hi("shadow")),this.haze.color.set(hi("ghost")),this.moved=!0}draw(e,t){let{renderer:n,canvas:s,camera:r}=this;this.moved=!1,this.fits||(n.setPixelRatio(Math.min(window.devicePixelRatio,2)),n.setSize(s.clientWidth,s.clientHeight,!1),this.fits=!0),this.centres.clear();for(let o of e){let{left:a,bottom:c,width:l,height:u}=this.placeOf(o.element);n.setViewport(a,c,l,u),n.setScissor(a,c,l,u);let d=l/u,h=3.45*Math.max(1,1.12/d);r.aspect=d,r.position.set(h*Math.cos(this.height)*Math.cos(this.azimuth),h*Math.cos(this.height)*Math.sin(this.azimuth),h*Math.sin(this.height)+ix),r.lookAt(0,0,ix),r.updateProjectionMatrix(),this.place(o,t),n.render(this.scene,r);let f=this.centre.setFromMatrixPosition(this.body.pitch.matrixWorld).project(r),p=s.clientHeight-c-u;this.centres.set(o.element,[a+(.5+.5*f.x)*l,p+(.5-.5*f.y)*u])}}placeOf(e){let t=this.places.get(e);if(t)return t;this.resized.observe(e);let n=this.canvas.getBoundingClientRect(),s=e.getBoundingClientRect(),r={left:s.left-n.left,bottom:n.bottom-s.bottom,width:s.width,height:s.height};return this.places.set(e,r),r}place({element:e,colour:t,x:n,u:s,ghost:r},o){this.accent.color.set(t),this.arrows.color.set(t),Rf(this.body,n),Rf(this.shadow,n),this.ghost.travel.visible=r!==null,r&&Rf(this.ghost,r);let a=this.spins.get(e)??[0,0];this.spins.set(e,a);let c=si(s,this.parameters);this.body.rotors.forEach(({blades:l,blur:u,arrow:d},h)=>{let f=c[h];a[h]+=(h?-1:1)*D1*s[h]*o,l.rotation.z=a[h],u.material.opacity=Math.min(.75*Math.abs(f),.6);let p=Math.max(L1*Math.abs(f),.001);d.scale.set(1,1,f<0?-1:1);let[_,g]=d.children,m=Math.min(.07,.6*p);_.scale.z=p-m,g.scale.setScalar(m),g.position.z=p-.5*m})}orbit(e,t){this.moved=!0,this.azimuth+=e,this.height=Math.min(Math.max(this.height+t,.05),1.45)}orbitByKeys(){let e={ArrowLeft:[.1,0],ArrowRight:[-.1,0],ArrowUp:[0,.1],ArrowDown:[0,-.1]};this.canvas.addEventListener("keydown",t=>{let n=e[t.key];!n||t.ctrlKey||t.metaKey||t.altKey||(this.orbit(...n),t.preventDefault())})}onBodyDrag=null;orbitByDragging(){let e=this.canvas.parentElement;this.resized.observe(e);let t=null;e.addEventListener("touchstart",s=>{this.onBodyDrag&&s.touches.length===1&&this.hitsBody(s.touches[0])&&s.preventDefault()},{passive:!1}),e.addEventListener("pointerdown",s=>{!this.onBodyDrag||!this.hitsBody(s)||(t={x:s.clientX,y:s.clientY},e.setPointerCapture(s.pointerId),e.classList.add("pushing"))});let n=()=>{t=null,this.onBodyDrag?.(0,0),e.classList.remove("pushing")};e.addEventListener("pointerup",n),e.addEventListener("pointercancel",n),e.addEventListener("pointermove",s=>{s.buttons!==0&&(t?this.onBodyDrag?.(s.clientX-t.x,s.clientY-t.y):this.orbit(-.008*s.movementX,.005*s.movementY))})}hitsBody({clientX:e,clientY:t}){let n=this.canvas.getBoundingClientRect();return[...this.centres.values()].some(([s,r])=>Math.hypot(e-n.left-s,t-n.top-r)<N1)}};function Ou(i,e,t){try{return new Pf(i,e,t)}catch{return i.parentElement.dataset.message="The 3D view needs WebGL, which this browser does not offer.",null}}function Rf({travel:i,elevation:e,pitch:t},n){i.rotation.z=n[0],e.rotation.y=n[2],t.rotation.x=n[4]}function Uu(i,e){for(let[t,n]of i){let{r:s,g:r,b:o}=new yt(n),a=t.getAttribute("position").count;t.setAttribute("color",new cn(Array.from({length:a},()=>[s,r,o]).flat(),3))}return new Bn(nx(i.map(([t])=>t)),e)}function qi(i,e,t,n=0,s=0,r=0){let o=new No(e,e,i,24);return t==="x"&&o.rotateZ(Math.PI/2),t==="z"&&o.rotateX(Math.PI/2),o.translate(n,s,r)}var If=(i,e,t,n=0,s=0,r=0)=>new or(i,e,t).translate(n,s,r),ox=()=>new Uo({vertexColors:!0});function F1(){return Uu([[qi(.03,.17,"z",0,0,al+.015),Ns],[qi(-al-.04,.024,"z",0,0,al/2-.02),Ho],[qi(.05,.045,"z",0,0,-.07),Ns]],ox())}function ax({l_h:i,l_p:e,l_c:t,d_c:n}){let s=[.028,-.028].map(a=>[If(.05,.012,.09,0,a,-.012),Ns]),r=[[qi(.07,.008,"y"),Ho],[qi(i+t-.02,.011,"x",(i-t)/2),Ho],[qi(n,.007,"z",-t,0,-n/2),Ho],[qi(.1,.06,"x",-t,0,-n),U1]],o=[[qi(2*e,.009,"y"),Ns],[If(.06,.09,.03),Ns],[qi(.05,.014,"x"),Ho],...[e,-e].map(a=>[qi(.045,.016,"z",0,a,.01),Ns])];return[s,r,o]}var Fu=i=>new Ga(Cf,.006,10,48).translate(0,i,.03);function lx(i,[e,t,n]){let[s,r,o]=[new vi,new vi,new vi];return s.add(e,r),r.add(t,o),o.add(n),o.position.set(i.l_h,0,i.e_h),{travel:s,elevation:r,pitch:o}}function O1(i,e,t){let n=ox(),[s,r,o]=ax(i);o.push([Fu(-i.l_p),Ho]);let a=lx(i,[s,r,o].map(u=>Uu(u,n))),c=new Bn(Fu(i.l_p),e);a.pitch.add(c);let l=[i.l_p,-i.l_p].map(u=>{let d=Uu([[If(2*Cf-.03,.018,.003),Ns]],n);d.position.set(0,u,.034);let h=new as({color:"#5b6675",transparent:!0,depthWrite:!1,side:Ii});h.forceSinglePass=!0;let f=new Bn(new Do(Cf-.008,40),h);f.position.set(0,u,.032);let p=new vi;return p.position.set(0,u,.04),p.add(new Bn(qi(1,.009,"z",0,0,.5),t),new Bn(new ka(.4,1,20).rotateX(Math.PI/2),t)),a.pitch.add(d,f,p),{blades:d,blur:f,arrow:p}});return{...a,rotors:l}}function cx(i,e){let[t,n,s]=ax(i);return s.push([Fu(i.l_p),Ns],[Fu(-i.l_p),Ns]),lx(i,[t,n,s].map(r=>Uu(r,e)))}function B1(i,e){let t=cx(i,e),[n,s,r]=rx,[o,a,c]=[al+.003,-n/r,-s/r],l=new vi;return l.matrixAutoUpdate=!1,l.matrix.set(1,0,a,-a*o,0,1,c,-c*o,0,0,0,o,0,0,0,1),l.add(t.travel),t}function k1(){let i=document.createElement("canvas"),e=1536;i.width=i.height=e;let t=i.getContext("2d"),n=e/2/sx;t.fillStyle="#e3e8ef",t.fillRect(0,0,e,e),t.translate(e/2,e/2),t.strokeStyle="#aab5c2",t.fillStyle="#6b7786",t.lineWidth=.008*n,t.beginPath(),t.arc(0,0,.66*n,0,2*Math.PI),t.stroke(),t.font=`600 ${.09*n}px system-ui, sans-serif`,t.textAlign="center",t.textBaseline="middle";for(let o=0;o<360;o+=15){t.save(),t.rotate(-o*Math.PI/180);let a=o%90===0;t.beginPath(),t.moveTo((a?.72:.76)*n,0),t.lineTo(.8*n,0),t.stroke(),a&&(t.translate(.9*n,0),t.rotate(-Math.PI/2),t.fillText(`${o}\xB0`,0,0)),t.restore()}let s=new Fa(i);s.colorSpace=Kn,s.anisotropy=8;let r=new Bn(new Do(sx,96),new as({map:s}));return r.position.z=al,r}var Uf=2,z1=30,Rn="feedforward+tvlqr",G1=.95,Bu=({experiment:i,flights:e},t)=>t in e&&i.endError(e[t])<=Uf,Yi=i=>i.filter(({wasPushed:e,experiment:t})=>!e&&!t.log),Lf=({experiment:i,flights:e},t)=>{let n=i.rmsError(e[t]);return Number.isFinite(n)?`${Nn(n,2)}\xB0`:"no arrival"},V1=({experiment:i},e)=>`${(vs(i.setup,e)??Number.NaN).toFixed(2)} s`;function H1({experiment:i},e,t){let{setup:n}=i,s=vs(n,t),{durations:r,windows:o}=Xs(yn(t,n.rig),n.method);return!o.flatMap(c=>r.map(l=>({...n,window:c,duration:l}))).map(c=>({other:c,takes:vs(c,t)??1/0})).filter(({takes:c})=>c<s-1e-6).sort((c,l)=>l.takes-c.takes).some(({other:c})=>{let l=yr.make(c,t),u=l?.fly(e);return l&&u&&l.endError(u)<=Uf})}function ux({experiment:i}){let e=Qr(i.plant),t=gs.filter(n=>Math.abs(e[n])>1e-9);return i.setup.startOff>0?[...t,"start"]:t}var Df=i=>new Set(Yi(i).filter(e=>"open-loop"in e.flights&&e.experiment.endError(e.flights["open-loop"])>z1).map(ux).filter(e=>e.length===1).flat()),Nf=i=>{let e=Yi(i).filter(({flights:t})=>Rn in t);return e.flatMap(t=>e.flatMap(n=>{let[s,r]=[t.experiment.setup,n.experiment.setup];return JSON.stringify({...s,window:0,method:0})===JSON.stringify({...r,window:0,method:0})&&r.window[0]>s.window[0]&&r.window[1]<s.window[1]?[[t,n]]:[]}))},ll=[{id:"fastest",title:"Find the fastest plan that arrives on lab",text:"The fastest plan uses all of the voltage, and a real plant has lag, friction and weaker rotors. Change duration and voltage window: with which plan is the paper's controller within 2\xB0 of the goal the soonest, at the moment when the plan ends?",setup:{method:"spline",duration:10,pitchLimit:50,window:[0,12],plant:"lab",draw:2,startOff:3},policies:[Rn],goals:[{text:"Fly a plan that arrives",isReached:i=>Yi(i).some(e=>Bu(e,Rn))},{text:"Fly one that does not",isReached:i=>Yi(i).some(e=>Rn in e.flights&&!Bu(e,Rn))},{text:"Fly the fastest that arrives, of all windows",isReached:(i,e)=>Yi(i).some(t=>t.experiment.setup.plant==="lab"&&t.experiment.setup.pitchLimit===50&&Bu(t,Rn)&&H1(t,Rn,e))}],report:(i,e)=>Yi(i).slice(-4).map(t=>`${V1(t,e)}, ${t.experiment.setup.window.join(" to ")} V: ${Nn(t.experiment.endError(t.flights[Rn]),1)}\xB0 off`).join("; "),lesson:"A plan with a reserve may arrive sooner than a faster one without: feedback takes voltage too. Try another draw."},{id:"open-loop",title:"Why does the open loop fail?",text:"The plan is exact for equation (3). See that its voltages alone arrive on the nominal plant from the right start. Then change one thing only, and find two different things, each of which alone takes the open loop more than 30\xB0 off.",setup:{method:"paper",duration:10,pitchLimit:50,window:[1,11],plant:"nominal",startOff:0},policies:["open-loop"],goals:[{text:"Open loop on the nominal plant from the right start: it arrives",isReached:i=>Yi(i).some(e=>ux(e).length===0&&Bu(e,"open-loop"))},{text:"One thing alone makes it miss",isReached:i=>Df(i).size>=1},{text:"A second one does too",isReached:i=>Df(i).size>=2}],report:i=>{let e=[...Df(i)];return e.length?`Alone enough: ${e.join(", ")}.`:""},lesson:"Nothing pulls the travel back: an acceleration that is slightly wrong is integrated twice. Feedback (51) closes that gap."},{id:"reserve",title:"What does the reserve buy?",text:"Plan twice with the same duration: once with all of the voltage (0 to 12 V), once with a reserve (1 to 11 V). Fly both on lab with the paper's controller, and compare the errors.",setup:{method:"spline",duration:8.5,pitchLimit:50,window:[0,12],plant:"lab",draw:1,startOff:3},policies:[Rn],goals:[{text:"Fly a plan without reserve",isReached:i=>Yi(i).some(({experiment:e,flights:t})=>Rn in t&&e.setup.window.join()===e.rig.amplifier.join())},{text:"Fly one with a reserve, all else equal",isReached:i=>Nf(i).length>0},{text:"Find a duration at which the reserve changes the error by more than a tenth",isReached:i=>Nf(i).some(([e,t])=>{let[n,s]=[e,t].map(({experiment:r,flights:o})=>r.rmsError(o[Rn]));return Math.abs(n-s)>.1*Math.min(n,s)})}],report:i=>Nf(i).slice(-2).map(([e,t])=>[e,t].map(n=>{let{experiment:s,flights:r}=n;return`${s.setup.window.join(" to ")} V: ${Lf(n,Rn)} RMS, ${Nn(100*s.saturation(r[Rn]),0)} % of the time at the amplifier's limits`}).join("; ")).join(". "),lesson:"A plan inside its limits leaves voltage to the feedback, which would otherwise saturate. The price is a longer fastest plan."},{id:"weights",title:"Beat the paper's controller with your weights",text:"Both fly the same feedforward. Change the weights of (49), and track travel and elevation on lab with an RMS error at least 5 % smaller than that of the paper's controller.",setup:{method:"paper",duration:10,pitchLimit:50,window:[1,11],plant:"lab",draw:1,startOff:3},policies:[Rn,"yours"],goals:[{text:"Fly your weights next to the paper's",isReached:i=>Yi(i).some(({flights:e,experiment:t})=>Rn in e&&"yours"in e&&Object.values(t.setup.weights).some(n=>n!==0))},{text:"Error at least 5 % smaller",isReached:i=>Yi(i).some(({flights:e,experiment:t})=>Rn in e&&"yours"in e&&t.setup.plant==="lab"&&t.rmsError(e.yours)<G1*t.rmsError(e[Rn]))}],report:i=>Yi(i).filter(({flights:e})=>Rn in e&&"yours"in e).slice(-3).map(e=>`yours ${Lf(e,"yours")}, the paper's ${Lf(e,Rn)}`).join("; "),lesson:"Stiffer is better only until lag and delay answer: more weight on travel makes the pitch swing. The gains are below."}],cl=class{constructor(e,t){this.data=e;let n=ll.map((s,r)=>{this.goals.push(s.goals.map(({text:l})=>J("li",{},l))),this.notes.push({report:J("p",{class:"small"}),lesson:J("p",{class:"lesson",hidden:!0},s.lesson)});let o=J("button",{"data-task":s.id,click:()=>{this.active=r,this.seen[r]=[],t(s)}},"set it up"),{report:a,lesson:c}=this.notes[r];return J("details",{class:"task",name:"task"},J("summary",{},s.title),J("p",{class:"small"},s.text),o,J("ul",{class:"goals"},...this.goals[r]),J("div",{role:"status"},a,c))});this.element=J("div",{class:"tasks"},...n)}data;element;goals=[];notes=[];seen=ll.map(()=>[]);reached=ll.map(({goals:e})=>e.map(()=>!1));active=-1;complete(e){if(this.active<0)return;let[t,n]=[ll[this.active],this.active];this.seen[n].push(e),t.goals.forEach(({isReached:s},r)=>{this.reached[n][r]||=s(this.seen[n],this.data),this.goals[n][r].classList.toggle("done",this.reached[n][r])}),this.notes[n].report.textContent=t.report(this.seen[n],this.data),this.notes[n].lesson.hidden=!this.reached[n].every(Boolean)}};var W1=[.25,.5,1,2,4],X1=.1,hx=[{label:"\u25C0 pitch",key:"ArrowLeft",axis:2,acceleration:-6},{label:"pitch \u25B6",key:"ArrowRight",axis:2,acceleration:6},{label:"\u25B2 lift",key:"ArrowUp",axis:1,acceleration:-3},{label:"\u25BC press",key:"ArrowDown",axis:1,acceleration:3}],Ff={perPixel:.05,most:8},dx=["1","2","3","4"],fx=["5","6","7","8","9","0"],q1={nominal:"Equation (3), exactly: what the controllers assume.",lab:"(3) with rotor lag, friction, thrust loss, a delay, and encoders.",rigid:"The full rigid body, with the rotors, friction and encoders of lab.",fleet:"Rigs of measured flights: uneven rotors, drifting thrust, wrong sensor zeros, a table."};function gx(i,e){let t=i.control_period,n=matchMedia("(prefers-reduced-motion: reduce)"),s=i.policies.map(({colour:$})=>$),r=wl(location.hash,i),o=r.setup,a=i.policies.map(({name:$})=>r.shown.includes($)),c=null,l=null,u=[],d=[],h=[0,0],f=0,p=!1,_=!0,g=1,m=i.policies.map(({label:$},pe)=>new Zr($,s[pe],pe)),y=J("canvas",{tabindex:0,role:"application","aria-label":"helicopters in 3D: drag or use the arrow keys to look from elsewhere, drag a body to push it; the numbers are below each"}),A=J("div",{class:"stage"},y,...m.map($=>$.element)),S=new $r,P=i.policies.map(({label:$},pe)=>({label:$,colour:s[pe],mark:pe})),E={label:"plan",colour:"",dashed:!0},x=[],b=$=>{we(),re(!1),f=Math.min(Math.max($,0),M()),ae(),f>=M()&&Ae(),_=!0},N=($,pe)=>{let Ne=new Zs({...$,duration:1,onTime:b});return x.push({plot:Ne,...pe}),Ne},R=($,pe,Ne="deg")=>N({title:$,unit:Ne,lines:[...P,E],...pe===4&&{limits:[0,0]}},{value:Ke=>$t(Ke[pe]),planned:!0}),L=P.map($=>({...$,held:!0})),z=($,pe)=>N({title:$,unit:"V",lines:[...L,E],limits:[0,0],range:[0,12]},{value:(Ne,Ke)=>Ke[pe],planned:!0});R("travel",0),R("elevation",2,"deg, positive down");let H=R("pitch",4),D=[z("front voltage",0),z("back voltage",1)];N({title:"travel error",unit:"deg",lines:P,range:[-.1,.1]},{value:($,pe,Ne)=>$t($[0]-c.reference.x[Ne][0])});let G=new Gl(i.policies,t,P,b),k=[],U=($,pe,Ne,Ke)=>{let gt=J("input",{type:"range",id:$}),Ft=J("output",{for:$}),St=()=>{let{min:jt,max:Ot,step:It,value:Xt,text:rn}=Ne();Object.assign(gt,{min:`${jt}`,max:`${Ot}`,step:`${It}`}),gt.value=`${Xt}`,gt.setAttribute("aria-valuetext",rn),Ft.textContent=rn};return gt.addEventListener("input",()=>{Ke(Number(gt.value)),Se()}),k.push(St),J("div",{class:"slider"},J("label",{for:$},pe),Ft,gt)},se=()=>Xs(yn(i,o.rig),o.method),X=()=>({...ua(o,se()),startOff:o.startOff}),Y={duration:()=>{let $=vs(o,i);return o.duration===null?`fastest${$===null?"":`, ${$.toFixed(2)} s`}`:`${o.duration.toFixed(1)} s`},pitch:()=>`\xB1${o.pitchLimit}\xB0`,window:()=>`${px(o.window[0])} to ${px(o.window[1])} V`,startOff:()=>`${o.startOff}\xB0`},ie=($,pe,Ne,Ke)=>U($,pe,()=>({min:0,max:Ne()-1,step:1,value:X()[$],text:Y[$]()}),Ke),ce=$=>o={...o,...$},he=J("select",{id:"rig"},...i.rigs.map(({name:$})=>J("option",{value:$},$))),Q=J("p",{class:"small"});he.addEventListener("change",()=>{let $=Ws(i,yn(i,he.value));o=_s({...$,startOff:o.startOff,plant:o.plant,draw:o.draw,weights:o.weights},i),l=null,te()});let ge=J("select",{id:"method"},J("option",{value:"paper"},"paper's, (38)"),J("option",{value:"spline"},"splines"));ge.addEventListener("change",()=>{o=_s({...o,method:ge.value},i),te()});let _e=J("p",{class:"message",role:"status",hidden:!0}),Te=J("button",{id:"remedy",hidden:!0,click:()=>{let $=fe("spline");$&&(o=$),te()}}),xe=J("button",{click:()=>{o={...o,...Ge()},te()}},"the paper's values"),Ge=()=>{let{method:$,duration:pe,pitchLimit:Ne,window:Ke}=Ws(i,yn(i,o.rig));return{method:$,duration:pe,pitchLimit:Ne,window:Ke}},qe=i.policies.map(({label:$},pe)=>{let Ne=J("input",{type:"checkbox",id:`policy-${pe}`});return Ne.addEventListener("change",()=>Ee(pe,Ne.checked)),{box:Ne,label:J("label",{},Ne,ni(pe,s[pe]),$)}}),ke=J("p",{class:"small",role:"status",id:"plant-note"}),it=J("button",{click:()=>de()},"another draw"),ot=J("div",{class:"segments",role:"radiogroup","aria-label":"plant"}),rt=gs.map($=>{let{name:pe,unit:Ne,digits:Ke,min:gt,max:Ft,step:St}=es[$],jt=()=>Qr(da(o,i).plant)[$];return U($,pe,()=>({min:gt,max:Ft,step:St,value:jt(),text:`${Nn(jt(),Ke)} ${Ne}`}),Ot=>ce({effects:{...o.effects,[$]:Ot}}))}),ve=J("button",{click:()=>{ce({effects:{}}),te()}},"as drawn"),me=xs.map($=>U(`weight-${$}`,$==="effort"?"effort (R)":`${$} (Q)`,()=>({min:-2,max:2,step:.25,value:o.weights[$],text:`\xD7 ${Number((10**o.weights[$]).toPrecision(2))}`}),pe=>{ce({weights:{...o.weights,[$]:pe}}),a[i.policies.findIndex(Ne=>Ne.name==="yours")]=!0})),Fe=new cl(i,$=>{let pe=Ws(i,i.rigs[0]);o=_s({...pe,...$.setup},i),i.policies.forEach(({name:Ne},Ke)=>a[Ke]=$.policies.includes(Ne)),l=null,te()}),We=J("button",{class:"primary",id:"play",click:()=>re(!p)}),at=J("button",{click:()=>B()},"Restart"),ut=J("select",{"aria-label":"speed",id:"speed"},...W1.map($=>J("option",{value:$,selected:$===1},`${$}\xD7`)));ut.addEventListener("change",()=>g=Number(ut.value));let Kt=J("output",{class:"clock"}),Yt=hx.map($=>J("button",{class:"push",click:()=>Me($.axis,$.acceleration)},$.label)),zt=J("p",{class:"small",role:"status"}),O=J("input",{type:"file",accept:".csv,text/csv",id:"log",class:"hidden-file"});O.addEventListener("change",()=>{O.files?.[0]&&He(O.files[0]),O.value=""});let De=J("button",{hidden:!0,click:()=>{l=null,te()}},"back to the plan"),tt=J("button",{click:async()=>{await(navigator.clipboard?.writeText(location.href)??Promise.reject()).then(()=>zt.textContent="The address of this flight is in the clipboard.",()=>zt.textContent=location.href)}},"copy link"),ft=J("button",{id:"csv",click:()=>{let $=i.policies.flatMap(({name:pe},Ne)=>u[Ne]?[[pe,u[Ne]]]:[]);c&&Sl("flight.csv",new Blob([Eh($,c.reference,t)],{type:"text/csv"}))}},"CSV"),Ce=J("button",{id:"png",click:()=>{Pe(0),Ah(y,m.flatMap(({element:pe})=>pe.hidden?[]:[pe]),x.map(({plot:pe})=>pe),q()).toBlob(pe=>pe&&Sl("flight.png",pe))}},"PNG"),Pt=($,...pe)=>J("fieldset",{},J("legend",{},$),...pe),Ye=($,...pe)=>J("details",{},J("summary",{},$),...pe),et=J("div",{class:"stack"},J("label",{class:"choice",for:"method"},"plan by",ge),ie("duration","duration",()=>se().durations.length,$=>ce({duration:se().durations[$]})),ie("pitch","pitch limit",()=>se().pitch_limits_deg.length,$=>ce({pitchLimit:se().pitch_limits_deg[$]})),ie("window","voltage window",()=>se().windows.length,$=>ce({window:se().windows[$]})),_e,Te,xe);e.classList.add("live"),e.append(J("header",{},J("h1",{},"3-DOF helicopter"),J("p",{},"A 360\xB0 rotation between two points of rest, planned within limits and flown in your browser.")),A,J("div",{class:"transport"},We,at,Kt,J("span",{class:"pushes"},J("span",{},"push"),...Yt),ut),J("div",{class:"panels"},...x.map(({plot:$})=>$.element)),G.element,J("aside",{},Pt("Tasks",Fe.element),Pt("Rig and plan",J("label",{class:"choice",for:"rig"},"rig",he),Ye("where its numbers are from",Q),et),Pt("Flight",ie("startOff","start off by",()=>11,$=>ce({startOff:$})),J("div",{class:"toggles"},...qe.map(({label:$})=>$)),Ye("your weights in (49)",J("p",{class:"small"},"Factors on the paper's Q and R, for the policy \u201Cyour weights\u201D."),...me)),Pt("Plant",ot,ke,J("div",{class:"row"},it),Ye("its effects, one by one",...rt,ve)),Pt("Files",J("div",{class:"row"},ft,Ce,tt),J("label",{class:"file"},"open a recorded flight (CSV)",O),De,zt),_l([["Space","fly, pause"],["R","restart"],["\u2190 \u2192","push the pitch; on a plot, move the time; on the 3D view, look around"],["\u2191 \u2193","lift, press the body"],[dx.join(" "),"nominal, lab, rigid, fleet"],["D","another draw of the plant"],[fx.join(" "),"show or hide each policy"]]),J("p",{class:"small"},"Pale helicopter and dashed lines: the plan. Shaded: beyond its limits. The start is off in travel and elevation. Drag a body to push it."),S.element));let C=Ou(y,yn(i,o.rig).body,yn(i,o.rig).parameters);C&&(C.onBodyDrag=($,pe)=>{let Ne=Ke=>Math.min(Math.max(Ff.perPixel*Ke,-Ff.most),Ff.most);h=[Ne($),Ne(pe)],h.some(Ke=>Ke!==0)&&!p&&f<M()&&re(!0)});let M=()=>t*(c?.steps??0),q=()=>{let{rig:$,plant:pe,startOff:Ne}=o,Ke=l?`recorded flight ${l.name}`:`${Y.duration()}, pitch ${Y.pitch()}, ${Y.window()}`;return`rig ${$}, plant ${pe}; ${Ke}; start off by ${Ne}\xB0`};function fe($){for(let pe of Xs(yn(i,o.rig),$).durations){let Ne=_s({...o,method:$,duration:pe},i);if(ha(Ne,i))return Ne}return null}let le=!1;function Se(){le=!0,k.forEach($=>$())}function we(){le&&te()}function te(){le=!1;let $=yn(i,o.rig);c=yr.make(o,i,l),ye($);let pe=c===null;if(_e.hidden=Te.hidden=!pe,A.classList.toggle("stale",pe),oe(),pe){let[Ke,gt]=[fe(o.method),fe("spline")],Ft=gt&&vs(gt,i);_e.textContent=[`No plan for ${Y.duration()} within ${Y.pitch()} and ${Y.window()}`,o.method==="paper"?Ke?`: the paper's method finds none below ${vs(Ke,i).toFixed(1)} s`:": the paper's method finds none":"",Ft===null?".":`; the fastest of the splines takes ${Ft.toFixed(2)} s.`].join(""),Te.hidden=gt===null,Te.textContent=Ft===null?"":`take the spline of ${Ft.toFixed(2)} s`,re(!1);return}C?.setRig($.body,$.parameters);let Ne=eo(o);H.setLimits(Ne.pitch.map($t)),D.forEach(Ke=>{Ke.setLimits(Ne.u),Ke.setRange($.amplifier)}),x.forEach(({plot:Ke})=>Ke.setDuration(M())),G.rebuild(c,a),B(!n.matches)}function oe(){let $=i.policies.flatMap(({name:pe},Ne)=>a[Ne]?[pe]:[]);try{history.replaceState(null,"",Ph(o,$,i)||location.pathname+location.search)}catch{}}function ye($){k.forEach(St=>St()),he.value=$.name,Q.textContent=$.source||"from a file",ge.value=o.method,ge.options[0].disabled=!$.grids.paper,xe.textContent=$.grids.paper?"the paper's values":"as at first",et.hidden=l!==null,De.hidden=l===null,i.policies.forEach(({name:St},jt)=>{let Ot=St!=="residual"||Object.values($.networks).some(({learned:It})=>It!==null);qe[jt].label.hidden=!Ot,qe[jt].box.checked=a[jt],je(jt,a[jt]&&Ot)});let pe=Object.keys($.plants);ot.dataset.names!==pe.join()&&(ot.dataset.names=pe.join(),ot.replaceChildren(...pe.map(St=>{let jt=J("input",{type:"radio",name:"plant",value:St});return jt.addEventListener("change",()=>st(St)),J("label",{},jt,J("span",{},St))})));for(let St of ot.querySelectorAll("input"))St.checked=St.value===o.plant;let{plant:Ne,isRandom:Ke}=da(o,i);it.hidden=!Ke,ve.hidden=Object.keys(o.effects).length===0;let gt=Qr(Ne),Ft=St=>`${es[St].name} ${Nn(gt[St],es[St].digits)} ${es[St].unit}`;ke.textContent=(q1[o.plant]??"")+(Ke?` Draw ${o.draw}: ${gs.filter(St=>Math.abs(gt[St])>1e-9).map(Ft).join(", ")}.`:"")+($.networks[$.network_for[o.plant]]?.learned?` The residual policy was trained on ${$.network_for[o.plant]}.`:"")}function B($=!0){c!==null&&(f=0,d=[],u=i.policies.map(()=>null),ae(),re($))}function ae(){if(c===null)return;let $=Math.min(Math.ceil(f/t-1e-9),c.steps),pe=Math.max(0,...u.map(Ne=>Ne?Ne.x.length-1:0));$>pe&&h.forEach((Ne,Ke)=>{Ne!==0&&(d=[...d,{axis:2-Ke,acceleration:Ne,time:pe*t,duration:($-pe)*t}])}),i.policies.forEach(({name:Ne},Ke)=>{if(!a[Ke])return;let gt=u[Ke]??=c.begin(Ne);for(;gt&&gt.x.length<=$&&!gt.crashed;)gt.step(d)})}function re($){let pe=f>=M(),Ne=$&&pe&&f>0;if(p=$&&c!==null,_=!0,p&&Ne){B();return}We.textContent=p?"Pause":pe&&f>0?"Fly again":"Fly",We.disabled=c===null}function Ae(){re(!1);let $=i.policies.flatMap(({name:pe},Ne)=>u[Ne]?[[pe,u[Ne]]]:[]);Fe.complete({experiment:c,flights:Object.fromEntries($),wasPushed:d.length>0})}function Me($,pe){let Ne=Math.max(0,...u.map(Ke=>Ke?Ke.x.length-1:0));d=[...d,{axis:$,acceleration:pe,time:Ne*t,duration:X1}]}function Ee($,pe){a[$]=qe[$].box.checked=pe,pe||(u[$]=null),je($,pe),ae(),oe(),_=!0}function je($,pe){m[$].element.hidden=!pe,x.forEach(({plot:Ne})=>Ne.setVisible($,pe)),G.setVisible($,pe)}function st($){ce({plant:$,effects:{}}),te()}function de(){ce({draw:o.draw+1,effects:{}}),te()}async function He($){try{l=Rh(await $.text(),$.name,t/2)}catch(Ne){zt.textContent=Ne.message;return}i.policies.forEach(({name:Ne},Ke)=>a[Ke]=Ne==="open-loop"),ce({startOff:0}),te();let pe=Ch(l,c.plant,c.rules);zt.textContent=`${$.name}: ${(l.step*(l.x.length-1)).toFixed(1)} s. Dashed and pale: the record; \u201Copen loop\u201D: the model under the recorded voltages. One second ahead, the model is off by ${["travel","elevation","pitch"].map((Ne,Ke)=>`${Nn(pe[Ke],1)}\xB0 of ${Ne}`).join(", ")} (RMS).`}function nt($){let{plot:pe,value:Ne,planned:Ke}=x[$],{x:gt,middle:Ft}=c.reference,St=gt.map((Ot,It)=>It*t),jt=u.map(Ot=>St.map((It,Xt)=>Ot&&Xt<Ot.x.length?Ne(Ot.x[Xt],Ot.u[Math.min(Xt,Ot.u.length-1)]??Ft[0],Xt):null));pe.show(St,Ke?[...jt,gt.map((Ot,It)=>Ne(Ot,Ft[It],It))]:jt),pe.seek(f)}function Pe($){if(c===null)return;Kt.textContent=`${Nn(Math.min(f,M()),1)} s`;let pe=mx(c.reference.x,f/t),Ne=[];u.forEach((Ke,gt)=>{if(!Ke)return;let Ft=Math.min(f/t,Ke.x.length-1),St=mx(Ke.x,Ft),jt=Ke.crashed&&Ft>=Ke.x.length-1?`beyond \xB1${$t(c.rules.pitchStop).toFixed(0)}\xB0 of pitch: the flight ended`:"",Ot=Ke.u[Math.min(Math.floor(Ft),Ke.u.length-1)]??Ke.rotors;m[gt].show(St,Ot,jt),Ne.push({element:m[gt].element,colour:s[gt],x:St,u:jt?[0,0]:p?Ke.rotors:Ot,ghost:pe})}),C?.draw(Ne,$)}gl(A,()=>{re(!1),x.forEach(($,pe)=>nt(pe)),G.refresh(u,f,!0),Pe(0)});let mt=performance.now(),Wt=0;function Cn($){let pe=Math.min(Math.max(($-mt)/1e3,0),.1);mt=$,S.measure(()=>{if(we(),p&&(f=Math.min(f+g*pe,M()),ae(),f>=M()&&Ae()),!p&&!_&&!C?.moved)return;let Ne=!p&&_;_=!1,Pe(p?g*pe:0),c!==null&&(p&&Wt++%2?nt((Wt>>1)%x.length):p?G.refresh(u,f,!1):Ne&&(x.forEach((Ke,gt)=>nt(gt)),G.refresh(u,f,!0)))}),requestAnimationFrame(Cn)}window.addEventListener("keydown",$=>{if(xl($))return;let pe=$.key.length===1?$.key.toLowerCase():$.key,Ne=hx.find(Ft=>Ft.key===pe),Ke=Object.keys(yn(i,o.rig).plants)[dx.indexOf(pe)],gt=fx.indexOf(pe);if(Ne)Me(Ne.axis,Ne.acceleration);else if(pe===" ")re(!p);else if(pe==="r")B();else if(pe==="d"&&!it.hidden)de();else if(Ke)st(Ke);else if(qe[gt]&&!qe[gt].label.hidden)Ee(gt,!a[gt]);else return;$.preventDefault()}),window.addEventListener("hashchange",()=>{let $=wl(location.hash,i);o=$.setup,i.policies.forEach(({name:pe},Ne)=>a[Ne]=$.shown.includes(pe)),l=null,te()}),document.addEventListener("dragover",$=>$.preventDefault()),document.addEventListener("drop",$=>{$.preventDefault();let pe=$.dataTransfer?.files[0];pe&&He(pe)}),Gs(()=>_=!0),e.dataset.ready="",te(),requestAnimationFrame(Cn)}var px=i=>Nn(i,Number.isInteger(i)?0:1);function mx(i,e){let t=Math.min(Math.floor(e),i.length-1),n=i[Math.min(t+1,i.length-1)];return i[t].map((s,r)=>s+(e-t)*(n[r]-s))}var Wo=300,Y1=84,Or=62,ul=24,ku=class{element;marks;figures;place;constructor(e,t,n){let s=e.flat().filter(l=>l>0),r=Math.log10(Math.min(...s))-.05,o=Math.max(Math.log10(Math.max(...s))+.05,r+.2);this.place=l=>Wo*(Math.log10(Math.max(l,10**r))-r)/(o-r);let a=[.01,.02,.05,.1,.2,.5,1,2,5,10,20,50,100,200,500].filter(l=>Math.log10(l)>r&&Math.log10(l)<o),c=Math.ceil(a.length/7);this.marks=[],this.figures=e.map((l,u)=>{let d=new Array(ul).fill(0);for(let m of l)d[Math.min(ul-1,Math.max(0,Math.floor(ul*this.place(m)/Wo)))]+=1;let h=Math.max(...d,1),f=[...l].sort((m,y)=>m-y)[Math.floor(l.length/2)],p=`${t[u]}: ${l.length} episodes, median ${Nn(f??Number.NaN,2)}\xB0`,_=an("svg",{viewBox:`0 0 ${Wo} ${Y1}`,role:"img","aria-label":p});a.forEach((m,y)=>{if(y%c>0)return;let A=this.place(m);_.append(an("line",{x1:A,x2:A,y1:4,y2:Or,class:"grid"}),an("text",{x:A,y:Or+14,class:"tick"},`${m}`))}),d.forEach((m,y)=>{let A=(Or-6)*(m/h);_.append(an("rect",{x:y*Wo/ul+.5,width:Wo/ul-1,y:Or-A,height:A,fill:n[u]}))});let g=an("line",{y1:2,y2:Or+3,class:"mark"});return _.append(an("line",{x1:0,x2:Wo,y1:Or,y2:Or,class:"axis"}),g),this.marks.push(g),J("figure",{class:"histogram"},J("figcaption",{},J("span",{},ni(u,n[u]),p)),_)}),this.element=J("div",{class:"multiples"},...this.figures)}mark(e){this.marks.forEach((t,n)=>{let s=e[n];if(t.toggleAttribute("hidden",s==null),s==null)return;let r=this.place(s).toFixed(1);t.setAttribute("x1",r),t.setAttribute("x2",r)})}setVisible(e,t){this.figures[e].hidden=!t}};var $1=[.25,.5,1,2,4],Z1=["travel","elevation","pitch"],xx=["#0072B2","#56B4E9","#009E73","#E69F00","#CC79A7","#7A5195"],_x=["travel","travel rate","elevation","elevation rate","pitch","pitch rate"];function vx(i,e){let{policies:t,labels:n,colours:s,parameters:r,limits:o}=i,a=i.groups.map(({reference:ve,step:me})=>me*(ve.x[0].length-1)),c=t.map(()=>!0),l=i.groups[0],u=a[0],d=0,h=!1,f=1,p=J("table",{},J("thead",{},J("tr",{},...i.table.columns.map(ve=>J("th",{scope:"col"},ve)))),J("tbody",{},...i.table.rows.map((ve,me)=>J("tr",me>0&&ve[0]!==i.table.rows[me-1][0]?{class:"section"}:{},...ve.map((Fe,We)=>{let at=We===1?t.indexOf(Fe):-1;return at<0?J("td",{},Fe):J("td",{title:Fe},ni(at,s[at]),n[at])}))))),_=t.map((ve,me)=>new Zr(n[me],s[me],me)),g=J("canvas",{tabindex:0,role:"application","aria-label":"the flights in 3D; drag, or use the arrow keys, to look from elsewhere"}),m=J("div",{class:"stage"},g,..._.map(ve=>ve.element)),y=new $r,A={label:"plan",colour:"",dashed:!0},S=n.map((ve,me)=>({label:ve,colour:s[me],mark:me})),P=["front","back"],E={duration:u,sync:"report",onTime:ve=>qe(ve)},x=[],b=(ve,me,Fe="flights")=>{let We=new Zs({...E,...ve});return x.push({plot:We,values:me,lines:Fe}),We.element},N=ve=>l.reference.x[0].map((me,Fe)=>Fe<ve.length?ve[Fe]:null),R=ve=>N(ve.map($t)),L=o.pitch.map($t),z=Z1.flatMap((ve,me)=>[b({title:ve,unit:me===1?"deg, positive down":"deg",lines:[...S,A],...me===2&&{limits:L}},()=>[...l.flights.map(Fe=>R(Fe?.x[2*me]??[])),R(l.reference.x[2*me])]),b({title:`${ve} error`,unit:me===1?"deg, positive down":"deg",lines:S,digits:2,range:[-.01,.01]},()=>l.flights.map(Fe=>R((Fe?.x[2*me]??[]).map((We,at)=>We-l.reference.x[2*me][at]))))]),H=J("div",{class:"multiples"},...t.map((ve,me)=>b({title:n[me],unit:"V",lines:[...P.map((Fe,We)=>({label:Fe,colour:We===0?s[me]:"",held:!0})),...P.map(Fe=>({label:`${Fe}, plan`,colour:"#7f8a97",dashed:!0}))],limits:o.u,range:i.amplifier},()=>[...P.map((Fe,We)=>N(l.flights[me]?.u[We]??[])),...P.map((Fe,We)=>N(l.reference.u[We]))],me))),{gains:D}=i;if(D){let ve=_x.map((me,Fe)=>({label:me,colour:xx[Fe],mark:Fe}));z.push(J("div",{class:"legend wide"},..._x.map((me,Fe)=>J("span",{},ni(Fe,xx[Fe]),me))),...["thrust sum","thrust difference"].map((me,Fe)=>b({title:`gains on the ${me}`,unit:"N/rad and N s/rad",lines:ve,digits:1},()=>D.K[Fe].map(We=>l.reference.x[0].map((at,ut)=>Of(We,ut*l.step/D.step))),"gains")))}let G=([ve,me])=>[[ve,ve],[me,ve],[me,me],[ve,me]],k=ve=>{let[me,Fe]=Jr(ve,r);return[[0,2*me],[Fe-me,me+Fe],[0,2*Fe],[me-Fe,me+Fe]]},U=[new Ar({title:"voltages, (6)",axes:["front voltage (V)","back voltage (V)"],corners:G(o.u),outer:G(i.amplifier),ticks:[[0,3,6,9,12],[0,3,6,9,12]],colours:s}),new Ar({title:"virtual inputs, (17)\u2013(20)",axes:["thrust difference v2 (N)","thrust sum v1 (N)"],corners:k(o.u),outer:k(i.amplifier),ticks:[[-.6,-.3,0,.3,.6],[0,.4,.8,1.2]],colours:s})],se=i.errors.some(ve=>ve.length>1)?new ku(i.errors,n,s):null,X=J("dl",{class:"draw"}),Y=J("input",{type:"range",class:"time",min:0,max:u,step:.01,value:0,"aria-label":"time",id:"time"}),ie=J("output",{for:"time"}),ce=J("button",{class:"primary",click:()=>it(!h)},"Play"),he=J("select",{"aria-label":"speed"},...$1.map(ve=>J("option",{value:ve,selected:ve===1},`${ve}\xD7`))),Q=J("select",{"aria-label":"flights"},...i.groups.map(({label:ve},me)=>J("option",{value:me},ve))),ge=J("div",{class:"legend"},...t.map((ve,me)=>{let Fe=J("input",{type:"checkbox",checked:!0});return Fe.addEventListener("change",()=>Te(me,Fe.checked)),J("label",{title:ve},Fe,ni(me,s[me]),n[me])}),J("span",{class:"line dashed"},"plan"));Y.addEventListener("input",()=>qe(Number(Y.value))),he.addEventListener("change",()=>f=Number(he.value)),Q.addEventListener("change",()=>Ge(Number(Q.value))),e.append(J("header",{},J("h1",{},i.title),J("p",{},i.subtitle)),J("section",{},J("h2",{},"Results"),J("p",{},i.table.title),op("results",p),J("p",{class:"small"},i.table.caption)),J("section",{},J("h2",{},"Flights"),J("div",{class:"bar"},J("label",{},"flights ",Q),ge),m,X),...se===null?[]:[J("section",{},J("h2",{},"RMS error over all episodes (deg)"),se.element,J("p",{class:"small"},"Travel and elevation together, on a logarithmic axis; the line marks the flight that is shown."))],J("section",{},J("div",{class:"panels"},...z,...U.map(ve=>ve.element)),J("h2",{},"Voltages"),J("p",{class:"small"},"Coloured: front motor; black: back motor; dashed: the plan."),H,J("p",{class:"small"},"Shaded: beyond the limits of the plan. Drag across a plot to zoom, double-click to see all, click to go to a time.")),J("footer",{},_l([["Space","play, pause"],["\u2190 \u2192","0.1 s back, forwards (with Shift 1 s); on the 3D view, look around"],["Home End","to the start, to the end"],["1 2","first, second choice of flights"],["+ - 0","on a plot: zoom in, out, show all"]]),y.element),J("div",{class:"transport"},ce,Y,ie,he));let _e=Ou(g,i.rig,r);function Te(ve,me){c[ve]=me,xe(),ke(0)}function xe(){t.forEach((ve,me)=>{let Fe=c[me]&&l.flights[me]!==null;_[me].element.hidden=!Fe;for(let{plot:We,lines:at}of x)at==="flights"?We.setVisible(me,Fe):at===me&&(We.element.hidden=!Fe);for(let We of U)We.setVisible(me,Fe);se?.setVisible(me,c[me]&&i.errors[me].length>0)})}function Ge(ve){l=i.groups[ve],u=a[ve],Q.value=`${ve}`,Y.max=`${u}`;let me=l.reference.x[0].map((We,at)=>at*l.step);for(let{plot:We,values:at}of x)We.show(me,at());let Fe=l.flights.map(We=>(We?.u[0]??[]).map((at,ut)=>[at,We.u[1][ut]]));U[0].show(Fe),U[1].show(Fe.map(We=>We.map(at=>ri(at,r).reverse()))),X.replaceChildren(...l.draw.map(([We,at])=>J("div",{},J("dt",{},We),J("dd",{},at)))),X.hidden=l.draw.length===0,se?.mark(l.errors),xe(),qe(Math.min(d,u))}function qe(ve,me=0){d=Math.min(Math.max(ve,0),u),Y.value=`${d}`,ie.textContent=`${Nn(d,2)} s`;for(let{plot:Fe}of x)Fe.seek(d);for(let Fe of U)Fe.seek(Math.round(d/l.step));ke(me)}function ke(ve){let me=d/l.step,Fe=[],We=l.reference.x.map(at=>Of(at,me));l.flights.forEach((at,ut)=>{if(at===null)return;let Kt=at.x[0].length-1,Yt=at.x.map(O=>Of(O,me)),zt=at.u.map(O=>O[Math.min(Math.floor(me),Kt)]);_[ut].show(Yt,zt,me>Kt?at.ended:""),c[ut]&&Fe.push({element:_[ut].element,colour:s[ut],x:Yt,u:zt,ghost:We})}),_e?.draw(Fe,ve)}function it(ve){ve&&d>=u&&(d=0),h=ve,ce.textContent=ve?"Pause":"Play"}gl(m,()=>{it(!1),ke(0)});let ot=performance.now();function rt(ve){let me=Math.min(Math.max((ve-ot)/1e3,0),.1);ot=ve,y.measure(()=>{h?qe(d+f*me,f*me):_e?.moved&&ke(0)}),h&&d>=u&&it(!1),requestAnimationFrame(rt)}window.addEventListener("keydown",ve=>{if(xl(ve))return;let me=ve.shiftKey?1:.1,Fe={" ":()=>it(!h),ArrowLeft:()=>qe(d-me),ArrowRight:()=>qe(d+me),Home:()=>qe(0),End:()=>qe(u)},We=Number(ve.key)-1;if(i.groups[We])Ge(We);else if(Fe[ve.key])Fe[ve.key]();else return;ve.preventDefault()}),Gs(()=>ke(0)),Ge(0),requestAnimationFrame(rt)}function Of(i,e){let t=Math.min(Math.max(Math.floor(e),0),i.length-1),n=Math.min(t+1,i.length-1),s=Math.min(Math.max(e-t,0),1);return(1-s)*i[t]+s*i[n]}if(typeof document<"u"){let i=JSON.parse(document.getElementById("data").textContent),e=document.querySelector("main");document.body.dataset.kind==="live"?gx(i,e):vx(i,e)}return Ox(J1);})();
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
