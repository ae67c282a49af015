// The 3D view: surfaces in cells, the box around them, a camera that turns about its middle. Draws only when asked.
import {
  AmbientLight, BufferAttribute, BufferGeometry, DataTexture, DirectionalLight, DoubleSide, EdgesGeometry, BoxGeometry,
  Group, HemisphereLight, LinearFilter, LineBasicMaterial, LineSegments, Mesh, MeshStandardMaterial, PerspectiveCamera,
  Scene, SRGBColorSpace, Vector3, WebGLRenderer, PlaneGeometry, MeshBasicMaterial,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { ramp, vesicleColour } from "./colours.js";

const views = { fit: [0.62, -1, 0.5], x: [1, 0, 0], y: [0, -1, 0], z: [0, -0.0001, 1] };

export class View {
  constructor(canvas, box, { reducedMotion, moved }) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: false });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(30, 1, 1, 1e5);
    this.camera.up.set(0, 0, 1);
    this.moved = moved;
    this.box = box;
    this.middle = new Vector3(...box).multiplyScalar(0.5);
    this.addLights();
    this.addBox();
    this.meshes = new Map(); // vesicle -> mesh
    this.texture = new DataTexture(ramp("sequential"), 256, 1);
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.minFilter = this.texture.magFilter = LinearFilter;
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = !reducedMotion;
    this.controls.dampingFactor = 0.12;
    this.controls.target.copy(this.middle);
    this.controls.addEventListener("change", () => this.request());
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.direction = views.fit;
    this.resize();
  }

  addLights() {
    this.scene.add(new HemisphereLight(0xffffff, 0x9a9aa8, 1.35), new AmbientLight(0xffffff, 0.45));
    const key = new DirectionalLight(0xffffff, 1.75);
    key.position.set(-0.6, 0.9, 1);
    this.camera.add(key, key.target); // a lamp in the reader's hand: no side is ever dark
    key.target.position.set(0, 0, -1);
    this.scene.add(this.camera);
  }

  addBox() {
    this.frame = new Group();
    this.frame.position.copy(this.middle);
    this.lines = new LineBasicMaterial({ color: 0x888888, transparent: true, opacity: 0.7 });
    this.frame.add(new LineSegments(new EdgesGeometry(new BoxGeometry(...this.box)), this.lines));
    this.scene.add(this.frame);
  }

  // Walls are drawn where the box ends in them.
  addWalls(ends) {
    this.wall = new MeshBasicMaterial({ color: 0x808890, transparent: true, opacity: 0.13, side: DoubleSide, depthWrite: false });
    ends.forEach((end, axis) => {
      if (end !== "walls") return;
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      for (const side of [-0.5, 0.5]) {
        const plane = new Mesh(new PlaneGeometry(1, 1), this.wall);
        const size = axis === 0 ? [this.box[2], this.box[1]] : axis === 1 ? [this.box[0], this.box[2]] : [this.box[u], this.box[v]];
        plane.scale.set(size[0], size[1], 1);
        if (axis === 0) plane.rotation.y = Math.PI / 2;
        if (axis === 1) plane.rotation.x = Math.PI / 2;
        plane.position.setComponent(axis, side * this.box[axis]);
        this.frame.add(plane);
      }
    });
  }

  // The smallest distance from which the whole box is seen.
  distanceFor(direction) {
    const towards = new Vector3(...direction).normalize();
    const right = new Vector3().crossVectors(this.camera.up, towards).normalize();
    const up = new Vector3().crossVectors(towards, right);
    const tall = Math.tan((this.camera.fov * Math.PI) / 360) * 0.93;
    const wide = tall * this.camera.aspect;
    let distance = 1;
    for (let corner = 0; corner < 8; ++corner) {
      const at = new Vector3(...[0, 1, 2].map((k) => ((corner >> k) & 1 ? 0.5 : -0.5) * this.box[k]));
      const reach = Math.max(Math.abs(at.dot(right)) / wide, Math.abs(at.dot(up)) / tall);
      distance = Math.max(distance, at.dot(towards) + reach);
    }
    return distance;
  }

  look(name) {
    this.direction = views[name];
    const distance = this.distanceFor(this.direction);
    const towards = new Vector3(...this.direction).normalize();
    this.controls.target.copy(this.middle);
    this.camera.position.copy(this.middle).addScaledVector(towards, distance);
    this.camera.near = distance / 200;
    this.camera.far = distance * 20;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.untouched = true;
    this.request();
  }

  turn(sideways, upwards) {
    const from = this.camera.position.clone().sub(this.controls.target);
    from.applyAxisAngle(this.camera.up, sideways);
    const right = new Vector3().crossVectors(this.camera.up, from).normalize();
    const tilted = from.clone().applyAxisAngle(right, upwards);
    if (Math.abs(tilted.clone().normalize().z) < 0.995) from.copy(tilted);
    this.camera.position.copy(this.controls.target).add(from);
    this.controls.update();
    this.request();
  }

  zoom(factor) {
    this.camera.position.sub(this.controls.target).multiplyScalar(factor).add(this.controls.target);
    this.controls.update();
    this.request();
  }

  colours(range) {
    this.texture.image.data.set(ramp(range.scale, range.begin, range.end));
    this.texture.needsUpdate = true;
  }

  // surfaces: decoded ones; places(surface): texture coordinates, or null to use the vesicles' own colours.
  show(surfaces, places, isVisible) {
    for (const mesh of this.meshes.values()) {
      mesh.geometry.dispose();
      mesh.visible = false;
    }
    for (const surface of surfaces) {
      let mesh = this.meshes.get(surface.vesicle);
      if (!mesh) {
        mesh = new Mesh(undefined, new MeshStandardMaterial({ roughness: 0.62, metalness: 0, side: DoubleSide }));
        this.meshes.set(surface.vesicle, mesh);
        this.scene.add(mesh);
      }
      const coordinates = places(surface);
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(surface.positions, 3));
      geometry.setAttribute("normal", new BufferAttribute(surface.normals, 3));
      if (coordinates) geometry.setAttribute("uv", new BufferAttribute(coordinates, 2));
      geometry.setIndex(new BufferAttribute(surface.triangles, 1));
      mesh.geometry = geometry;
      const material = mesh.material;
      if ((material.map !== null) !== (coordinates !== null)) material.needsUpdate = true;
      material.map = coordinates ? this.texture : null;
      material.color.set(coordinates ? "#ffffff" : vesicleColour(surface.vesicle));
      mesh.visible = isVisible(surface.vesicle);
    }
    this.request();
  }

  dark(isDark) {
    this.lines.color.set(isDark ? 0x8e97a3 : 0x7d858f);
    if (this.wall) this.wall.color.set(isDark ? 0xaab4c0 : 0x76808c);
    this.request();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement.parentElement;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.untouched !== false) this.look(Object.keys(views).find((name) => views[name] === this.direction));
    this.request();
  }

  request() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.draw();
    });
  }

  draw() {
    this.controls.update(); // goes on by itself while it still glides
    this.renderer.render(this.scene, this.camera);
    this.moved(this.camera);
  }
}
