import {
  Bone,
  CapsuleGeometry,
  Float32BufferAttribute,
  MeshStandardMaterial,
  Skeleton,
  SkinnedMesh,
  Uint16BufferAttribute,
} from 'three';

const JOINTS = 6;
const LENGTH = 1.9;

/** A skinned mesh that sways. */
export function makeTentacle(): { mesh: SkinnedMesh; animate: (seconds: number) => void } {
  const geometry = new CapsuleGeometry(0.17, LENGTH, 8, 24, 24);
  geometry.translate(0, LENGTH / 2, 0);
  bindTo(geometry);
  const bones = Array.from({ length: JOINTS }, () => new Bone());
  bones.reduce((parent, bone) => {
    bone.position.y = LENGTH / (JOINTS - 1);
    return (parent.add(bone), bone);
  });
  const mesh = new SkinnedMesh(geometry, new MeshStandardMaterial({ color: '#a05bb0', roughness: 0.5 }));
  mesh.add(bones[0]);
  mesh.bind(new Skeleton(bones));
  mesh.position.set(0.5, 0, -1);
  const animate = (seconds: number) =>
    bones.forEach((bone, joint) => (bone.rotation.z = joint ? 0.22 * Math.sin(1.4 * seconds - 0.8 * joint) : 0));
  return { mesh, animate };
}

/** Each vertex is weighted to its two adjacent bones. */
function bindTo(geometry: CapsuleGeometry): void {
  const { position } = geometry.attributes;
  const joints: number[] = [];
  const weights: number[] = [];
  for (let vertex = 0; vertex < position.count; ++vertex) {
    const along = Math.min(Math.max((position.getY(vertex) / LENGTH) * (JOINTS - 1), 0), JOINTS - 1 - 1e-6);
    const joint = Math.floor(along);
    joints.push(joint, joint + 1, 0, 0);
    weights.push(1 - (along - joint), along - joint, 0, 0);
  }
  geometry.setAttribute('skinIndex', new Uint16BufferAttribute(joints, 4));
  geometry.setAttribute('skinWeight', new Float32BufferAttribute(weights, 4));
}
