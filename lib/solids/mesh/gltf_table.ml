module J = Gltf_json

type t = Read | Still | Refused of string

let words text = List.filter (fun w -> w <> "") (String.split_on_char ' ' text)

let begins prefix text =
  let n = String.length prefix in
  String.length text >= n && String.equal (String.sub text 0 n) prefix

(* {1 Properties} *)

let kind name ?(refused = []) read still =
  let all mark text = List.map (fun w -> (w, mark)) (words text) in
  (name, all Read read @ all Still still @ List.map (fun (w, what) -> (w, Refused what)) refused)

let kinds =
  [
    kind "glTF"
      "asset extensionsRequired extensionsUsed accessors buffers bufferViews meshes nodes scenes scene animations \
       cameras materials"
      "images samplers skins textures";
    kind "asset" "version minVersion" "copyright generator"; kind "scene" "nodes" "name";
    kind "node" "matrix translation rotation scale mesh weights children camera" "name"
      ~refused:[ ("skin", "a mesh on a skeleton") ];
    kind "mesh" "primitives weights" "name"; kind "primitive" "attributes indices mode targets material" "";
    kind "attributes" "POSITION" "NORMAL TANGENT";
    kind "target" "POSITION" "NORMAL TANGENT";
    kind "accessor" "bufferView byteOffset componentType normalized count type sparse min max" "name";
    kind "sparse" "count indices values" ""; kind "sparseIndices" "bufferView byteOffset componentType" "";
    kind "sparseValues" "bufferView byteOffset" "";
    kind "bufferView" "buffer byteOffset byteLength byteStride" "name target";
    kind "buffer" "uri byteLength" "name"; kind "animation" "channels" "samplers name";
    kind "channel" "target" "sampler"; kind "goal" "node path" "";
  ]

let numbered = [ "TEXCOORD_"; "COLOR_"; "JOINTS_"; "WEIGHTS_"; "_" ]
let is_numbered name = List.exists (fun p -> begins p name) numbered

let property kind name =
  match List.assoc_opt kind kinds with
  | None -> Scc_base.Bug.fail __POS__ ("no kind of object: " ^ kind)
  | Some own -> (
      match List.assoc_opt name own with
      | None when List.mem kind [ "attributes"; "target" ] && is_numbered name -> Some Still
      | found -> found)

(* {1 Extensions} *)

let quantization = "KHR_mesh_quantization"
let visibility = "KHR_node_visibility"
let draco = "KHR_draco_mesh_compression"

(* Of how surfaces look, of lights, and of data for programs. *)
let looks =
  words
    "KHR_materials_anisotropy KHR_materials_clearcoat KHR_materials_diffuse_transmission KHR_materials_dispersion \
     KHR_materials_emissive_strength KHR_materials_ior KHR_materials_iridescence \
     KHR_materials_pbrSpecularGlossiness KHR_materials_sheen KHR_materials_specular KHR_materials_subsurface \
     KHR_materials_transmission KHR_materials_unlit KHR_materials_variants KHR_materials_volume \
     KHR_materials_volume_scatter KHR_texture_basisu KHR_texture_transform KHR_lights_punctual KHR_xmp \
     KHR_xmp_json_ld ADOBE_materials_clearcoat_specular ADOBE_materials_clearcoat_tint \
     ADOBE_materials_thin_transparency EXT_lights_ies EXT_lights_image_based EXT_texture_astc EXT_texture_avif \
     EXT_texture_webp MPEG_texture_video MSFT_packing_normalRoughnessMetallic \
     MSFT_packing_occlusionRoughnessMetallic MSFT_texture_dds NV_materials_mdl"

(* Where they are not required. The numbers that a file has beside what is compressed are the same. A level of
   detail stands for others that are coarser. Outlines are drawn along edges; a manifold has the same triangles. *)
let beside =
  words
    "KHR_draco_mesh_compression EXT_meshopt_compression KHR_meshopt_compression KHR_audio_emitter \
     KHR_node_selectability KHR_node_hoverability EXT_mesh_features EXT_instance_features EXT_structural_metadata \
     EXT_mesh_manifold EXT_mesh_primitive_edge_visibility EXT_mesh_primitive_restart AGI_stk_metadata \
     CESIUM_primitive_outline FB_geometry_metadata GODOT_single_root GRIFFEL_bim_data MSFT_lod \
     MOZ_hubs_components OMI_audio_emitter MPEG_audio_spatial MPEG_viewport_recommended"

let makes =
  [
    ("EXT_mesh_gpu_instancing", "copies of a mesh"); ("KHR_gaussian_splatting", "clouds without surfaces");
    ("EXT_primitive_voxels", "voxels"); ("EXT_implicit_ellipsoid_region", "implicit regions");
    ("AGI_articulations", "parts that are moved by settings"); ("MPEG_accessor_timed", "data that change in time");
    ("MPEG_mesh_linking", "a mesh that moves another one");
  ]

(* Of the whole file: they move things while time passes. *)
let moves =
  words "KHR_interactivity MPEG_scene_dynamic MPEG_media MPEG_buffer_circular MPEG_animation_timing \
         KHR_animation_pointer"

let extension name =
  if List.mem name looks || List.mem name beside then Some Still
  else if List.mem name [ quantization; visibility ] then Some Read
  else if List.mem name moves then Some (Refused "what changes while time passes")
  else Option.map (fun what -> Refused what) (List.assoc_opt name makes)

let required name = List.mem name looks || String.equal name quantization || String.equal name visibility

let check_extensions all =
  let one name =
    match extension name with
    | Some (Read | Still) -> Ok ()
    | Some (Refused what) -> J.fail all "the extension %s is not read: %s" (Text.quote name) what
    | None -> J.fail all "the extension %s is not known here: export the scene without it" (Text.quote name)
  in
  Result.map ignore (Result.all one (J.keys all))

(* In the words of the specification. *)
let noun kind =
  match kind with
  | "glTF" -> "a glTF file"
  | "asset" | "accessor" | "attributes" | "animation" -> "an " ^ kind
  | "sparseIndices" -> "indices of a sparse accessor"
  | "sparseValues" -> "values of a sparse accessor"
  | "goal" -> "the target of a channel"
  | "target" -> "a morph target"
  | _ -> "a " ^ kind

let check ~kind v =
  let one name =
    match (name, J.member name v) with
    | _, None | "extras", _ -> Ok ()
    | "extensions", Some all ->
      let* () = J.is_object all in
      if List.mem kind [ "glTF"; "goal" ] then Ok () else check_extensions all
    | _, Some value -> (
        match property kind name with
        | Some (Read | Still) -> Ok ()
        | Some (Refused what) -> J.fail value "%s is not read" what
        | None -> J.fail v "%s is no property of %s that is known here" (Text.quote name) (noun kind))
  in
  let* () = J.is_object v in
  Result.map ignore (Result.all one (J.keys v))

(* An extension of the whole file mostly declares what objects may use, where it is met again. *)
let undeclared root =
  let silent name =
    match extension name with
    | Some (Read | Still) -> false
    | Some (Refused _) -> List.mem name moves
    | None -> true
  in
  match J.member "extensions" root with
  | Some all -> List.find_opt silent (J.keys all)
  | None -> None
