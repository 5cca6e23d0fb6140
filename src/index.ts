/** Exports of the package. No module of the library imports this file. */
export { CartoonSmokeElement } from './page/element/cartoonSmokeElement.ts';
export type { ElementProperties } from './page/element/attributes/properties.ts';
export type { SmokeEvent, SmokeEvents, StateChange } from './page/element/events.ts';
export type { StageMethods } from './page/element/methods.ts';
export { driveByAudio, type AudioDriverOptions } from './page/drivers/audio.ts';
export type { DrivenSmoke, Driver, DriverOptions } from './page/drivers/driver.ts';
export { driveByMidi, type MidiDriverOptions } from './page/drivers/midi.ts';
export { driveByPointer, type PointerDriverOptions } from './page/drivers/pointer.ts';
export type { DrivenRanges } from './page/drivers/ranges.ts';
export { driveByScroll, type ScrollDriverOptions } from './page/drivers/scroll.ts';
export {
  createDevice,
  type ContextEvent,
  type Device,
  type DeviceCanvas,
  type DeviceOptions,
} from './renderer/gpu/device.ts';

export type { AssetUrls } from './base/assetUrls.ts';
export { setAssetUrls } from './base/setAssetUrls.ts';
export {
  ContextError,
  FileError,
  LoadError,
  ParameterError,
  ShapeError,
  SimulatorError,
  SmokeError,
  UnsupportedError,
} from './base/errors.ts';

export type { AnyValues, ShareLink, Value, Values } from './parameters/parameter.ts';
export type {
  ItemIndex,
  ItemValues,
  ListValues,
  PresetName,
  ScopeValues,
  SingleValues,
} from './parameters/valueTypes.ts';
export { presetValues } from './parameters/presets.ts';
export {
  readTimeline,
  whyNotAnimated,
  writeTimeline,
  type Easing,
  type GivenValues,
  type Keyframe,
  type Lane,
  type Timeline,
  type TimelineBurst,
} from './parameters/timeline.ts';
export { presets, type Preset } from './parameters/words/presets.ts';
export type { DebugView, Quality } from './parameters/quality.ts';
export type { PlainMesh } from './renderer/puffs/fit/closedMesh.ts';
export type { ShapeSource } from './page/outline/trace.ts';
export { traceShape } from './page/outline/traceShape.ts';
export { drawPuff } from './renderer/puffs/drawing/drawPuff.ts';
export type { DrawnArea, Line, Point, PuffDrawing } from './renderer/puffs/drawing/drawing.ts';
export { fitPuff, type FitOptions, type FittedPuff } from './renderer/puffs/fit/fitPuff.ts';
export { designedShapes, type PuffDesign } from './renderer/puffs/lobeShapes.ts';
export type { PuffKnobs } from './renderer/puffs/procedural.ts';
export type { Lobe, PixelImage, PuffMesh, PuffShape, PuffTile } from './renderer/puffs/shapes.ts';
export { readPuffSheet, type ReadSheetOptions } from './renderer/puffs/sheet/readPuffSheet.ts';
export type { PackedPuffs, PuffTextures } from './renderer/puffs/sheet/sheet.ts';
export { writePuffSheet, type WriteSheetOptions } from './renderer/puffs/sheet/writePuffSheet.ts';
export { CartoonSmoke } from './three/cartoonSmoke.ts';
export type {
  CartoonSmokeEvents,
  CartoonSmokeOptions,
  CartoonSmokeStats,
  CastOptions,
  LightSource,
} from './three/options.ts';
export type { LightReference } from './three/sceneLight.ts';
export type { CollideOptions } from './three/colliders.ts';
export type {
  BurstOptions,
  EmissionChange,
  EmissionOptions,
  EmitterLook,
  EmitterOptions,
  PuffOptions,
  VectorComponents,
} from './simulator/emitterOptions.ts';
export type { LookStyle } from './simulator/lookStyles.ts';

export type { EmitterHandle } from './three/emitters.ts';
export type { SmokeSpace } from './three/smokeSpace.ts';
export type { SmokeHandle } from './three/handle.ts';
export type { KeyLight } from './three/keyLight.ts';
export { capsule, type ProxyBall, type ProxyCapsule } from './three/proxies.ts';
export type { RemoteStage, RemoteStageOptions, Thread } from './stage/remote/contract.ts';
export type { MethodName, RemoteMethod, RemoteMethods } from './stage/remote/calls.ts';
export { connectFrame, type ConnectOptions } from './stage/remote/connectFrame.ts';
export { openStage } from './stage/remote/openStage.ts';
export type { Vector } from './scenes/scene.ts';
export type { LoadProgress } from './simulator/load.ts';
export type { RigidSurface } from './simulator/rigid.ts';
export type {
  BlowInput,
  EnterOptions,
  Model,
  ModelNode,
  ModelOptions,
  ModelPoint,
  PointerInput,
  SeekOptions,
  StageEvents,
  StageOptions,
  StageStats,
  StatsOptions,
} from './stage/contract.ts';
export type { PicturePoint, ScenePlane, Sight } from './stage/sight.ts';
export { createStage, type Stage } from './stage/stage.ts';
export type { Take, TakeOptions } from './stage/take.ts';
