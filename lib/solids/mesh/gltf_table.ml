module J = Gltf_json

let words text = List.filter (fun w -> w <> "") (String.split_on_char ' ' text)

let begins prefix text =
  let n = String.length prefix in
  String.length text >= n && String.equal (String.sub text 0 n) prefix

(* Properties that are read, and those that are still. *)
let properties =
  [
    ( "glTF",
      "asset extensionsRequired extensionsUsed accessors buffers bufferViews meshes nodes scenes scene animations",
      "cameras images materials samplers skins textures" );
    ("scene", "nodes", "name");
    ("node", "matrix translation rotation scale mesh skin weights children", "name camera");
    ("mesh", "primitives weights", "name"); ("primitive", "attributes indices mode", "material targets");
    ("accessor", "bufferView byteOffset componentType normalized count type sparse", "name min max");
    ("sparse", "count indices values", "");
    ("bufferView", "buffer byteOffset byteLength byteStride", "name target");
    ("buffer", "uri byteLength", "name");
  ]

let attributes = [ "POSITION"; "NORMAL"; "TANGENT" ]
let numbered = [ "TEXCOORD_"; "COLOR_"; "JOINTS_"; "WEIGHTS_"; "_" ]
let quantization = "KHR_mesh_quantization"

(* Of how surfaces look, of lights, sounds and links, and of data for programs. *)
let still = [ "KHR_materials_"; "KHR_texture_"; "KHR_lights_"; "EXT_texture_"; "MSFT_texture_"; "EXT_lights_" ]

(* The numbers that a file has beside what is compressed are the same; outlines are drawn along edges. *)
let still_too =
  words
    "KHR_xmp KHR_xmp_json_ld KHR_draco_mesh_compression EXT_meshopt_compression KHR_meshopt_compression \
     KHR_audio_emitter KHR_node_selectability KHR_node_hoverability EXT_mesh_features EXT_instance_features \
     EXT_structural_metadata      CESIUM_primitive_outline \
     EXT_mesh_primitive_edge_visibility FB_geometry_metadata \
     MSFT_packing_normalRoughnessMetallic \
     MSFT_packing_occlusionRoughnessMetallic ADOBE_materials_clearcoat_specular \
     MOZ_hubs_components OMI_audio_emitter"

let is_still name = List.exists (fun p -> begins p name) still

let required name =
  is_still name || String.equal name quantization || List.mem name (words "KHR_xmp KHR_xmp_json_ld")

let known kind name =
  if String.equal kind "attributes" then List.mem name attributes || List.exists (fun p -> begins p name) numbered
  else
    match List.find_opt (fun (k, _, _) -> String.equal k kind) properties with
    | Some (_, read, still) -> List.mem name (words read) || List.mem name (words still)
    | None -> Scc_base.Bug.fail __POS__ ("no kind of object: " ^ kind)

(* An extension of the whole file declares what objects may use, where it is met again. *)
let check_extensions ~kind v =
  match J.member "extensions" v with
  | Some all when not (String.equal kind "glTF") ->
    let unknown name = not (is_still name || List.mem name still_too) in
    (match List.find_opt unknown (J.keys all) with
     | Some name -> J.fail all "the extension %s is not read: export the scene without it" (Text.quote name)
     | None -> Ok ())
  | Some _ | None -> Ok ()

let check ~kind v =
  let unknown name =
    not (List.mem name [ "extensions"; "extras" ] && not (String.equal kind "attributes") || known kind name)
  in
  match List.find_opt unknown (J.keys v) with
  | Some name -> J.fail v "%s is no property of a glTF %s that is known here" (Text.quote name) kind
  | None -> check_extensions ~kind v
