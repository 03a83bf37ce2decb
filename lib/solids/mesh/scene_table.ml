type role = Group | Transform | Switch | Levels | Inline | Shape | Geometry | Points
type t = Read of { role : role; read : string list; still : string list } | Still | Left_out | Unread of string

let words text = List.filter (fun w -> w <> "") (String.split_on_char ' ' text)

(* {1 Nodes that are read: their fields that are read, and those that are still} *)

let box = "bboxCenter bboxSize bboxDisplay"
let surface = "color colorPerVertex normal normalPerVertex texCoord fogCoord attrib solid"
let moved = "children visible translation rotation scale center scaleOrientation"

let read =
  [
    (Group, "Group StaticGroup", "children visible", box);
    (Group, "PickableGroup", "children visible", box ^ " description objectType pickable");
    ( Group, "Anchor", "children visible",
      box ^ " description parameter url load autoRefresh autoRefreshTimeLimit" );
    (Group, "Collision", "children visible", box ^ " proxy enabled collide description");
    (Group, "CADAssembly CADLayer", "children visible", box ^ " name");
    (Group, "CADFace", "shape children visible", box ^ " name");
    (Transform, "Transform", moved, box); (Transform, "CADPart", moved, box ^ " name");
    (Switch, "Switch", "choice children whichChoice visible", box);
    (Levels, "LOD", "level children visible", box ^ " center range forceTransitions");
    (Inline, "Inline", "url load visible", box ^ " description global autoRefresh autoRefreshTimeLimit");
    (Shape, "Shape", "geometry visible", box ^ " appearance castShadow");
    ( Geometry, "IndexedFaceSet", "coord coordIndex ccw",
      surface ^ " colorIndex normalIndex texCoordIndex convex creaseAngle" );
    (Geometry, "TriangleSet QuadSet", "coord ccw", surface);
    (Geometry, "TriangleStripSet", "coord stripCount ccw", surface);
    (Geometry, "TriangleFanSet", "coord fanCount ccw", surface);
    ( Geometry, "IndexedTriangleSet IndexedTriangleStripSet IndexedTriangleFanSet IndexedQuadSet",
      "coord index ccw", surface );
    (Geometry, "ElevationGrid", "xDimension zDimension xSpacing zSpacing height ccw", surface ^ " creaseAngle");
    (Geometry, "Box", "size", "solid"); (Geometry, "Sphere", "radius", "solid");
    (Geometry, "Cylinder", "radius height bottom side top", "solid");
    (Geometry, "Cone", "bottomRadius height bottom side", "solid");
    ( Geometry, "Extrusion", "crossSection spine scale orientation beginCap endCap ccw",
      "solid convex creaseAngle" );
    (Geometry, "PointSet", "coord", "color normal attrib fogCoord");
    (Points, "Coordinate CoordinateDouble", "point", "");
  ]

(* {1 Nodes that change no place of a point, as their specifications list them by component} *)

let still =
  [
    "MetadataBoolean MetadataDouble MetadataFloat MetadataInteger MetadataSet MetadataString \
     WorldInfo";
    "ComposedCubeMapTexture GeneratedCubeMapTexture ImageCubeMapTexture";
    "Background Fog FogCoordinate LocalFog TextureBackground";
    "ProximitySensor TransformSensor VisibilitySensor";
    "BooleanFilter BooleanSequencer BooleanToggle BooleanTrigger IntegerSequencer IntegerTrigger \
     TimeTrigger";
    "ColorChaser ColorDamper CoordinateChaser CoordinateDamper OrientationChaser OrientationDamper \
     PositionChaser PositionChaser2D PositionDamper PositionDamper2D ScalarChaser ScalarDamper \
     TexCoordChaser2D TexCoordDamper2D";
    "GeoMetadata GeoOrigin GeoPositionInterpolator GeoProximitySensor GeoTouchSensor GeoViewpoint";
    "ColorInterpolator CoordinateInterpolator CoordinateInterpolator2D EaseInEaseOut \
     NormalInterpolator OrientationInterpolator PositionInterpolator PositionInterpolator2D \
     ScalarInterpolator SplinePositionInterpolator SplinePositionInterpolator2D \
     SplineScalarInterpolator SquadOrientationInterpolator";
    "KeySensor StringSensor";
    "ScreenFontStyle";
    "DirectionalLight PointLight SpotLight";
    "NurbsOrientationInterpolator NurbsPositionInterpolator NurbsSurfaceInterpolator \
     NurbsTextureCoordinate";
    "NavigationInfo OrthoViewpoint Viewpoint ViewpointGroup";
    "LoadSensor";
    "LinePickSensor PointPickSensor PrimitivePickSensor VolumePickSensor";
    "CylinderSensor PlaneSensor SphereSensor TouchSensor";
    "Color ColorRGBA Normal";
    "Script";
    "ComposedShader FloatVertexAttribute Matrix3VertexAttribute Matrix4VertexAttribute \
     PackagedShader ProgramShader ShaderPart ShaderProgram";
    "AcousticProperties Appearance FillProperties LineProperties Material PhysicalMaterial \
     PointProperties TwoSidedMaterial UnlitMaterial";
    "Analyser AudioClip AudioDestination BiquadFilter BufferAudioSource ChannelMerger \
     ChannelSelector ChannelSplitter Convolver Delay DynamicsCompressor Gain ListenerPointSource \
     MicrophoneSource OscillatorSource PeriodicWave Sound SpatialSound StreamAudioDestination \
     StreamAudioSource WaveShaper";
    "FontStyle";
    "TextureProjector TextureProjectorParallel";
    "ImageTexture MovieTexture MultiTexture MultiTextureCoordinate MultiTextureTransform \
     PixelTexture TextureCoordinate TextureCoordinateGenerator TextureProperties TextureTransform";
    "ComposedTexture3D ImageTexture3D PixelTexture3D TextureCoordinate3D TextureCoordinate4D \
     TextureTransform3D TextureTransformMatrix3D";
    "TimeSensor"
  ]

(* Fields that refer to nodes of any kind, which show nothing there; "*" is each that an author may declare. *)
let referring =
  [
    ("Script ComposedShader PackagedShader ShaderProgram", "*"); ("TransformSensor", "targetObject");
    ("LinePickSensor PointPickSensor PrimitivePickSensor VolumePickSensor", "pickTarget pickingGeometry");
    ("LoadSensor", "watchList children"); ("GeoMetadata", "data"); ("Collision", "proxy");
  ]

(* {1 Nodes without thickness: lines and letters} *)

let left_out = "IndexedLineSet LineSet Polyline2D Arc2D Circle2D Text"

(* {1 What can be done about others} *)

let cures =
  [
    ("ProtoInstance", "put the nodes of the prototype in its place");
    ("IMPORT", "put the nodes of the other file into this one");
    ("Billboard", "it turns with the place of whoever looks: put a Group or a Transform in its place");
    ("ClipPlane", "cut the shape itself, and remove the plane");
    ("GeoCoordinate", "convert the points to metres in a Coordinate");
    ("ScreenGroup", "its size depends on the screen: put a Transform with a scale in its place");
  ]

let cure =
  let table = List.concat_map (fun (kinds, cure) -> List.map (fun k -> (k, cure)) (words kinds)) cures in
  fun kind ->
    let usual = "write it as an IndexedFaceSet, as most programs can, or export the scene as PLY, OFF or STL" in
    Option.value (List.assoc_opt kind table) ~default:usual

(* {1 The table} *)

module By_kind = Map.Make (String)

let table =
  let put row rows kinds = List.fold_left (fun rows kind -> By_kind.add kind row rows) rows (words kinds) in
  let one rows (role, kinds, read, fields) =
    put (Read { role; read = words read; still = "metadata" :: words fields }) rows kinds
  in
  List.fold_left one (List.fold_left (put Still) (put Left_out By_kind.empty left_out) still) read

let find kind = match By_kind.find_opt kind table with Some row -> row | None -> Unread (cure kind)
let refers kind field =
  let has (kinds, fields) =
    let own = String.equal fields "*" && not (List.mem field [ "metadata"; "parts" ]) in
    List.mem kind (words kinds) && (own || List.mem field (words fields))
  in
  List.exists has referring

let kinds = List.map fst (By_kind.bindings table)

let usual kind =
  match find kind with
  | Read { role = Geometry; _ } | Left_out -> "geometry"
  | Read { role = Points; _ } -> "coord"
  | Read { role = Group | Transform | Switch | Levels | Inline | Shape; _ } | Still | Unread _ -> "children"
