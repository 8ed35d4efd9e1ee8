// The rig in 3D: several helicopters side by side, each in the rectangle of its own element, all on one canvas.

import {
  BoxGeometry,
  type BufferGeometry,
  CanvasTexture,
  CircleGeometry,
  Color,
  ConeGeometry,
  CylinderGeometry,
  DirectionalLight,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  HemisphereLight,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PerspectiveCamera,
  SRGBColorSpace,
  Scene,
  TorusGeometry,
  Vector3,
  WebGLRenderer,
} from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import { onTheme, printing, themed } from "./dom";
import type { RigidBody } from "./equations";
import { type Model, type Pair, thrusts } from "./model";

/** What is drawn in one rectangle. */
export interface Pose {
  element: HTMLElement;
  colour: string;
  x: readonly number[];
  u: Pair; // V, at the motors
  ghost: readonly number[] | null; // the reference's state
}

const FLOOR = -0.7; // m, below the joint of travel and elevation
const CENTRE = -0.23; // m, the height that the camera looks at
const SUN: [number, number, number] = [0.25, -0.4, 2.4]; // the direction of the light; high, so that shadows stay near
const FLOOR_RADIUS = 1.0; // m
const ROTOR_RADIUS = 0.1; // m
const ARROW = 0.62; // m per N
const SPIN = 4; // rad/s per V: slow enough that the blades are seen to turn

const BODY_REACH = 46; // px, within which a drag takes hold of a body

const METAL = "#8f9aa8";
const DARK = "#39424e";
const BRASS = "#b08d57";

interface Joints {
  travel: Group;
  elevation: Group;
  pitch: Group;
}

interface Body extends Joints {
  rotors: { blades: Mesh; blur: Mesh<CircleGeometry, MeshBasicMaterial>; arrow: Group }[];
}

/** Draws poses. Throws where the browser has no WebGL. */
export class Stage {
  private readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new PerspectiveCamera(30, 1, 0.1, 20);
  private body!: Body;
  private ghost!: Joints;
  private shadow!: Joints;
  private rig: RigidBody | null = null;
  private parameters!: Model;
  private readonly floor = makeFloor();
  private readonly shade = new MeshBasicMaterial();
  private readonly haze = new MeshBasicMaterial({ transparent: true, opacity: 0.25, depthWrite: false });
  private readonly accent: MeshLambertMaterial;
  private readonly arrows: MeshBasicMaterial;
  private fits = false; // whether the drawing has the size of the canvas
  private readonly places = new Map<HTMLElement, { left: number; bottom: number; width: number; height: number }>();
  private readonly resized = new ResizeObserver(() => {
    if (printing()) return;
    this.places.clear();
    this.fits = false;
    this.moved = true;
  });
  private readonly centres = new Map<HTMLElement, [number, number]>(); // px from the top left, of the bodies
  private readonly centre = new Vector3();
  private readonly spins = new Map<HTMLElement, Pair>();
  /** Whether the reader looks from elsewhere since the last drawing. */
  moved = true;
  private azimuth = -0.62; // rad
  private height = 0.42; // rad

  constructor(
    private readonly canvas: HTMLCanvasElement,
    rig: RigidBody,
    parameters: Model,
  ) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setScissorTest(true);
    this.accent = new MeshLambertMaterial();
    this.arrows = new MeshBasicMaterial();
    const sun = new DirectionalLight("#ffffff", 2.4);
    sun.position.set(...SUN);
    this.scene.add(new HemisphereLight("#ffffff", "#aab4c2", 1.9), sun, this.floor, makePost());
    this.setRig(rig, parameters);
    this.camera.up.set(0, 0, 1);
    this.orbitByDragging();
    this.orbitByKeys();
    this.paint();
    onTheme(() => this.paint());
  }

  /** Draws another rig from now on. */
  setRig(rig: RigidBody, parameters: Model): void {
    this.parameters = parameters;
    if (rig === this.rig) return;
    this.rig = rig;
    const old = this.body ? [this.body.travel, this.ghost.travel, this.shadow.travel.parent!] : [];
    for (const group of old) {
      this.scene.remove(group);
      group.traverse((part) => part instanceof Mesh && part.geometry.dispose());
    }
    this.body = makeBody(rig, this.accent, this.arrows);
    this.ghost = silhouette(rig, this.haze);
    this.shadow = makeShadow(rig, this.shade);
    this.scene.add(this.body.travel, this.ghost.travel, this.shadow.travel.parent!);
    this.moved = true;
  }

  /** The colours that follow the reader's preference for light or dark. */
  private paint(): void {
    this.floor.material.color.set(themed("floor"));
    this.shade.color.set(themed("shadow"));
    this.haze.color.set(themed("ghost"));
    this.moved = true;
  }

  /** All poses, `seconds` after the last ones. */
  draw(poses: readonly Pose[], seconds: number): void {
    const { renderer, canvas, camera } = this;
    this.moved = false;
    if (!this.fits) {
      renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
      renderer.setSize(canvas.clientWidth, canvas.clientHeight, false);
      this.fits = true;
    }
    this.centres.clear();
    for (const pose of poses) {
      const { left, bottom, width, height } = this.placeOf(pose.element);
      renderer.setViewport(left, bottom, width, height);
      renderer.setScissor(left, bottom, width, height);
      const aspect = width / height;
      const distance = 3.45 * Math.max(1, 1.12 / aspect);
      camera.aspect = aspect;
      camera.position.set(
        distance * Math.cos(this.height) * Math.cos(this.azimuth),
        distance * Math.cos(this.height) * Math.sin(this.azimuth),
        distance * Math.sin(this.height) + CENTRE,
      );
      camera.lookAt(0, 0, CENTRE);
      camera.updateProjectionMatrix();
      this.place(pose, seconds);
      renderer.render(this.scene, camera);
      const centre = this.centre.setFromMatrixPosition(this.body.pitch.matrixWorld).project(camera);
      const top = canvas.clientHeight - bottom - height;
      this.centres.set(pose.element, [left + (0.5 + 0.5 * centre.x) * width, top + (0.5 - 0.5 * centre.y) * height]);
    }
  }

  /** Where an element is on the canvas. Remembered, because asking makes the browser lay out the page. */
  private placeOf(element: HTMLElement) {
    const known = this.places.get(element);
    if (known) return known;
    this.resized.observe(element);
    const frame = this.canvas.getBoundingClientRect();
    const box = element.getBoundingClientRect();
    const place = { left: box.left - frame.left, bottom: frame.bottom - box.bottom, width: box.width, height: box.height };
    this.places.set(element, place);
    return place;
  }

  private place({ element, colour, x, u, ghost }: Pose, seconds: number): void {
    this.accent.color.set(colour);
    this.arrows.color.set(colour);
    turn(this.body, x);
    turn(this.shadow, x);
    this.ghost.travel.visible = ghost !== null;
    if (ghost) turn(this.ghost, ghost);
    const spins = this.spins.get(element) ?? [0, 0];
    this.spins.set(element, spins);
    const forces = thrusts(u, this.parameters);
    this.body.rotors.forEach(({ blades, blur, arrow }, i) => {
      const force = forces[i];
      spins[i] += (i ? -1 : 1) * SPIN * u[i] * seconds;
      blades.rotation.z = spins[i];
      blur.material.opacity = Math.min(0.75 * Math.abs(force), 0.6);
      const length = Math.max(ARROW * Math.abs(force), 1e-3);
      arrow.scale.set(1, 1, force < 0 ? -1 : 1);
      const [shaft, tip] = arrow.children;
      const head = Math.min(0.07, 0.6 * length);
      shaft.scale.z = length - head;
      tip.scale.setScalar(head);
      tip.position.z = length - 0.5 * head;
    });
  }

  /** Turns the view by angles in rad. */
  private orbit(azimuth: number, height: number): void {
    this.moved = true;
    this.azimuth += azimuth;
    this.height = Math.min(Math.max(this.height + height, 0.05), 1.45);
  }

  private orbitByKeys(): void {
    const turns: Record<string, [number, number]> = { ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
    this.canvas.addEventListener("keydown", (event) => {
      const turned = turns[event.key];
      if (!turned || event.ctrlKey || event.metaKey || event.altKey) return;
      this.orbit(...turned);
      event.preventDefault();
    });
  }

  /** A drag that starts on a body pushes it, if anybody listens; any other drag turns the view. */
  onBodyDrag: ((dx: number, dy: number) => void) | null = null;

  private orbitByDragging(): void {
    const surface = this.canvas.parentElement!;
    this.resized.observe(surface);
    let held: { x: number; y: number } | null = null;
    // A finger on a body pushes it up and down too; elsewhere it scrolls the page.
    surface.addEventListener(
      "touchstart",
      (event) => {
        if (this.onBodyDrag && event.touches.length === 1 && this.hitsBody(event.touches[0])) event.preventDefault();
      },
      { passive: false },
    );
    surface.addEventListener("pointerdown", (event) => {
      if (!this.onBodyDrag || !this.hitsBody(event)) return;
      held = { x: event.clientX, y: event.clientY };
      surface.setPointerCapture(event.pointerId);
      surface.classList.add("pushing");
    });
    const release = () => {
      held = null;
      this.onBodyDrag?.(0, 0);
      surface.classList.remove("pushing");
    };
    surface.addEventListener("pointerup", release);
    surface.addEventListener("pointercancel", release);
    surface.addEventListener("pointermove", (event) => {
      if (event.buttons === 0) return;
      if (held) this.onBodyDrag?.(event.clientX - held.x, event.clientY - held.y);
      else this.orbit(-0.008 * event.movementX, 0.005 * event.movementY);
    });
  }

  /** Whether a pointer is near the body of a helicopter, as drawn last. */
  private hitsBody({ clientX, clientY }: { clientX: number; clientY: number }): boolean {
    const frame = this.canvas.getBoundingClientRect();
    return [...this.centres.values()].some(([x, y]) => Math.hypot(clientX - frame.left - x, clientY - frame.top - y) < BODY_REACH);
  }
}

/** Whether the stage works here. */
export function makeStage(canvas: HTMLCanvasElement, rig: RigidBody, parameters: Model): Stage | null {
  try {
    return new Stage(canvas, rig, parameters);
  } catch {
    canvas.parentElement!.dataset.message = "The 3D view needs WebGL, which this browser does not offer.";
    return null;
  }
}

/** Travel turns about the vertical, elevation tilts the arm (positive is down), pitch rolls the body about the arm. */
function turn({ travel, elevation, pitch }: Joints, x: readonly number[]): void {
  travel.rotation.z = x[0];
  elevation.rotation.y = x[2];
  pitch.rotation.x = x[4];
}

/** A shape in one colour; many are merged into one mesh, because each mesh costs time in every frame. */
type Part = [BufferGeometry, string];

function merged(parts: Part[], material: Material): Mesh {
  for (const [geometry, colour] of parts) {
    const { r, g, b } = new Color(colour);
    const count = geometry.getAttribute("position").count;
    geometry.setAttribute("color", new Float32BufferAttribute(Array.from({ length: count }, () => [r, g, b]).flat(), 3));
  }
  return new Mesh(mergeGeometries(parts.map(([geometry]) => geometry)), material);
}

/** A cylinder along x, y or z about a point; three's stand along y. */
function rod(length: number, radius: number, along: "x" | "y" | "z", x = 0, y = 0, z = 0): BufferGeometry {
  const geometry = new CylinderGeometry(radius, radius, length, 24);
  if (along === "x") geometry.rotateZ(Math.PI / 2);
  if (along === "z") geometry.rotateX(Math.PI / 2);
  return geometry.translate(x, y, z);
}

const box = (a: number, b: number, c: number, x = 0, y = 0, z = 0) => new BoxGeometry(a, b, c).translate(x, y, z);
const painted = () => new MeshLambertMaterial({ vertexColors: true });

function makePost(): Mesh {
  return merged(
    [
      [rod(0.03, 0.17, "z", 0, 0, FLOOR + 0.015), DARK],
      [rod(-FLOOR - 0.04, 0.024, "z", 0, 0, FLOOR / 2 - 0.02), METAL],
      [rod(0.05, 0.045, "z", 0, 0, -0.07), DARK],
    ],
    painted(),
  );
}

/** The parts that turn with travel, with elevation, and with pitch, but for the rotors. */
function partsOf({ l_h, l_p, l_c, d_c }: RigidBody): [Part[], Part[], Part[]] {
  const fork = [0.028, -0.028].map((y): Part => [box(0.05, 0.012, 0.09, 0, y, -0.012), DARK]);
  const arm: Part[] = [
    [rod(0.07, 0.008, "y"), METAL],
    [rod(l_h + l_c - 0.02, 0.011, "x", (l_h - l_c) / 2), METAL],
    [rod(d_c, 0.007, "z", -l_c, 0, -d_c / 2), METAL],
    [rod(0.1, 0.06, "x", -l_c, 0, -d_c), BRASS],
  ];
  const frame: Part[] = [
    [rod(2 * l_p, 0.009, "y"), DARK],
    [box(0.06, 0.09, 0.03), DARK],
    [rod(0.05, 0.014, "x"), METAL],
    ...[l_p, -l_p].map((y): Part => [rod(0.045, 0.016, "z", 0, y, 0.01), DARK]),
  ];
  return [fork, arm, frame];
}

const guard = (y: number) => new TorusGeometry(ROTOR_RADIUS, 0.006, 10, 48).translate(0, y, 0.03);

function nested(rig: RigidBody, [fork, arm, frame]: Mesh[]): Joints {
  const [travel, elevation, pitch] = [new Group(), new Group(), new Group()];
  travel.add(fork, elevation);
  elevation.add(arm, pitch);
  pitch.add(frame);
  pitch.position.set(rig.l_h, 0, rig.e_h);
  return { travel, elevation, pitch };
}

function makeBody(rig: RigidBody, accent: Material, arrows: Material): Body {
  const material = painted();
  const [fork, arm, frame] = partsOf(rig);
  frame.push([guard(-rig.l_p), METAL]);
  const body = nested(rig, [fork, arm, frame].map((parts) => merged(parts, material)));
  // The front rotor is known by its colour.
  const front = new Mesh(guard(rig.l_p), accent);
  body.pitch.add(front);
  const rotors = [rig.l_p, -rig.l_p].map((y) => {
    const blades = merged([[box(2 * ROTOR_RADIUS - 0.03, 0.018, 0.003), DARK]], material);
    blades.position.set(0, y, 0.034);
    const haze = new MeshBasicMaterial({ color: "#5b6675", transparent: true, depthWrite: false, side: DoubleSide });
    haze.forceSinglePass = true; // two would set the material up anew each time
    const blur = new Mesh(new CircleGeometry(ROTOR_RADIUS - 0.008, 40), haze);
    blur.position.set(0, y, 0.032);
    const arrow = new Group();
    arrow.position.set(0, y, 0.04);
    arrow.add(new Mesh(rod(1, 0.009, "z", 0, 0, 0.5), arrows), new Mesh(new ConeGeometry(0.4, 1, 20).rotateX(Math.PI / 2), arrows));
    body.pitch.add(blades, blur, arrow);
    return { blades, blur, arrow };
  });
  return { ...body, rotors };
}

/** The body in one colour, without what turns or grows. */
function silhouette(rig: RigidBody, material: Material): Joints {
  const [fork, arm, frame] = partsOf(rig);
  frame.push([guard(rig.l_p), DARK], [guard(-rig.l_p), DARK]);
  return nested(rig, [fork, arm, frame].map((parts) => merged(parts, material)));
}

/** The body once more, flattened onto the floor along the light: far less work than a shadow map. */
function makeShadow(rig: RigidBody, material: Material): Joints {
  const shadow = silhouette(rig, material);
  const [x, y, z] = SUN;
  const [height, a, b] = [FLOOR + 0.003, -x / z, -y / z];
  const flattened = new Group();
  flattened.matrixAutoUpdate = false;
  flattened.matrix.set(1, 0, a, -a * height, 0, 1, b, -b * height, 0, 0, 0, height, 0, 0, 0, 1);
  flattened.add(shadow.travel);
  return shadow;
}

/** A disc with the angles of travel around it. */
function makeFloor(): Mesh<CircleGeometry, MeshBasicMaterial> {
  const canvas = document.createElement("canvas");
  const size = 1536;
  canvas.width = canvas.height = size;
  const context = canvas.getContext("2d")!;
  const scale = size / 2 / FLOOR_RADIUS;
  context.fillStyle = "#e3e8ef";
  context.fillRect(0, 0, size, size);
  context.translate(size / 2, size / 2);
  context.strokeStyle = "#aab5c2";
  context.fillStyle = "#6b7786";
  context.lineWidth = 0.008 * scale;
  context.beginPath();
  context.arc(0, 0, 0.66 * scale, 0, 2 * Math.PI);
  context.stroke();
  context.font = `600 ${0.09 * scale}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  for (let degrees = 0; degrees < 360; degrees += 15) {
    context.save();
    context.rotate((-degrees * Math.PI) / 180); // the canvas turns clockwise
    const long = degrees % 90 === 0;
    context.beginPath();
    context.moveTo((long ? 0.72 : 0.76) * scale, 0);
    context.lineTo(0.8 * scale, 0);
    context.stroke();
    if (long) {
      context.translate(0.9 * scale, 0);
      context.rotate(-Math.PI / 2); // to be read from outside
      context.fillText(`${degrees}°`, 0, 0);
    }
    context.restore();
  }
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  map.anisotropy = 8;
  const floor = new Mesh(new CircleGeometry(FLOOR_RADIUS, 96), new MeshBasicMaterial({ map }));
  floor.position.z = FLOOR;
  return floor;
}
