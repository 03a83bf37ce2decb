(* The tetrahedron of the tests as glTF, whole and with faults. *)

let points = [| [ 0.; 0.; 0. ]; [ 1.25; 0.; 0. ]; [ 0.; 1.; 0. ]; [ 0.; 0.; 2. ] |]
let corners = [ [ 0; 2; 1 ]; [ 0; 1; 3 ]; [ 0; 3; 2 ]; [ 1; 2; 3 ] ]
let float32 add b x = add b (Int32.bits_of_float x)

(* The tetrahedron as glTF: every triangle has corners of its own. *)
let gltf_data =
  let b = Buffer.create 300 in
  List.iter (fun f -> List.iter (fun i -> List.iter (float32 Buffer.add_int32_le b) points.(i)) f) corners;
  List.iter (Buffer.add_uint8 b) (List.init 12 Fun.id);
  Buffer.contents b

let gltf_json ?(data = gltf_data) ?(uri = true) ?(head = "") ?(node = "") ?(sparse = "") ?(count = 12)
    ?(mode = "") ?(root = 0) ?(more = "") () =
  let uri =
    if uri then Printf.sprintf ",\"uri\":\"data:application/octet-stream;base64,%s\"" (Base64.encode_string data)
    else more
  in
  Printf.sprintf
    "{\"asset\":{\"version\":\"2.0\"}%s,\"scenes\":[{\"nodes\":[%d]}],\"nodes\":[{\"mesh\":0%s}],\
     \"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\"indices\":1%s}]}],\
     \"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":%d%s},\
     {\"bufferView\":1,\"componentType\":5121,\"type\":\"SCALAR\",\"count\":12}],\
     \"bufferViews\":[{\"buffer\":0,\"byteLength\":144},{\"buffer\":0,\"byteOffset\":144,\"byteLength\":12}],\
     \"buffers\":[{\"byteLength\":%d%s}]}"
    head root node mode count sparse (String.length data) uri

let glb ?(version = 2) json data =
  let b = Buffer.create 1000 in
  let chunk kind text =
    Buffer.add_int32_le b (Int32.of_int (String.length text));
    Buffer.add_int32_le b kind;
    Buffer.add_string b text
  in
  let padded s = s ^ String.make (-String.length s land 3) ' ' in
  Buffer.add_string b "glTF";
  Buffer.add_int32_le b (Int32.of_int version);
  let padded_size = (String.length json + 3) land lnot 3 in
  Buffer.add_int32_le b (Int32.of_int (28 + padded_size + String.length data));
  chunk 0x4E4F534Al (padded json);
  chunk 0x004E4942l data;
  Buffer.contents b

(* The rotation of 1 + k, only nearly of length 1, is a quarter turn about z; the matrix is its inverse. *)
let turned_back =
  gltf_json ~root:1
    ~node:",\"matrix\":[0,-1,0,0,1,0,0,0,0,0,1,0,0,0,0,1]},{\"rotation\":[0,0,0.7071,0.7071],\"children\":[0]" ()

(* A mirror, and every point moved and halved, undone by the numbers of the file. *)
let mirrored =
  let b = Buffer.create 300 in
  let put = float32 Buffer.add_int32_le b in
  let corner i =
    match points.(i) with
    | [ x; y; z ] -> List.iter put [ (x -. 1.) *. -2.; y; z /. 4. ]
    | _ -> Alcotest.fail "a vertex has three coordinates"
  in
  List.iter (fun f -> List.iter corner (List.rev f)) corners;
  List.iter (Buffer.add_uint8 b) (List.init 12 Fun.id);
  gltf_json ~data:(Buffer.contents b) ~node:",\"translation\":[1,0,0],\"scale\":[-0.5,1,4]" ()

(* The fourth corner of the sparse accessor is put right: (9, 9, 9) stands in the dense one. *)
let sparse =
  let dense = Bytes.of_string gltf_data in
  List.iter (fun k -> Bytes.set_int32_le dense (36 + (4 * k)) (Int32.bits_of_float 9.)) [ 0; 1; 2 ];
  let data = Bytes.to_string dense ^ String.sub gltf_data 36 12 ^ "\003" in
  let json =
    gltf_json ~data
      ~sparse:
        ",\"sparse\":{\"count\":1,\"values\":{\"bufferView\":2},\
         \"indices\":{\"bufferView\":2,\"byteOffset\":12,\"componentType\":5121}}" ()
  in
  let views = "\"byteOffset\":144,\"byteLength\":12}]" in
  let n = String.length views in
  let rec find i = if String.equal (String.sub json i n) views then i else find (i + 1) in
  let i = find 0 + n - 1 in
  String.sub json 0 i ^ ",{\"buffer\":0,\"byteOffset\":156,\"byteLength\":13}"
  ^ String.sub json i (String.length json - i)

let in_glb = gltf_json ~uri:false ()
let packed json = glb json gltf_data

let files =
  [
    ("glTF", "t.gltf", gltf_json ()); ("glTF told by its text", "t", gltf_json ());
    ("GLB", "t.glb", glb (gltf_json ~uri:false ()) gltf_data);
    ("GLB told by its text", "t", glb (gltf_json ~uri:false ()) gltf_data);
    ("glTF, turned and back", "t.gltf", turned_back); ("glTF, sparse", "t.gltf", sparse);
  ]

(* As those of the other formats. *)
let bad =
  [
    ("glTF, no JSON", "t.gltf", "{\"asset\": }", "1:1 SC0320"); ("glTF, no object", "t.gltf", "[]", "1:1 SC0320");
    ("glTF 1", "t.gltf", "{\"asset\":{\"version\":\"1.0\"}}", "1:1 SC0320");
    ("glTF, too deep", "t.gltf", "{\"a\":" ^ String.make 1_000_000 '[', "1:1 SC0320");
    ("GLB 1", "t.glb", glb ~version:1 (gltf_json ()) "", "1:5 SC0320");
    ("GLB, a wrong length", "t.glb",
     (let file = glb (gltf_json ~uri:false ()) gltf_data in
      String.sub file 0 8 ^ "\000\000\000\000" ^ String.sub file 12 (String.length file - 12)), "1:9 SC0320");
    ("glTF, no such material", "t.gltf", gltf_json ~mode:",\"material\":0" (), "1:1 SC0320");
    ("glTF, no such camera", "t.gltf", gltf_json ~node:",\"camera\":0" (), "1:1 SC0320");
    ("GLB cut short", "t.glb", String.sub (glb (gltf_json ()) "") 0 100, "1:12 SC0320");
    ("glTF without its data", "t.gltf", gltf_json ~uri:false (), "1:1 SC0320");
    ("glTF, more than the view has", "t.gltf", gltf_json ~count:13 (), "1:1 SC0320");
    ("glTF, a huge count", "t.gltf", gltf_json ~count:2_000_000_000 (), "1:1 SC0320");
    ("glTF, an index out of range", "t.gltf", gltf_json ~count:11 (), "1:1 SC0320");
    ("glTF, lines", "t.gltf", gltf_json ~mode:",\"mode\":1" (), "1:1 SC0320");
    ("glTF, a node inside of itself", "t.gltf", gltf_json ~node:",\"children\":[0]" (), "1:1 SC0320");
    ("glTF, no rotation", "t.gltf", gltf_json ~node:",\"rotation\":[0,0,0,0]" (), "1:1 SC0320");
    ("glTF, no affine matrix", "t.gltf",
     gltf_json ~node:",\"matrix\":[1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]" (), "1:1 SC0320");
    ("glTF, a skeleton", "t.gltf", gltf_json ~node:",\"skin\":0" (), "1:1 SC0320");
    ("glTF, an extension", "t.gltf",
     gltf_json ~head:",\"extensionsRequired\":[\"KHR_draco_mesh_compression\"]" (), "1:1 SC0320");
    ("glTF, infinity", "t.gltf",
     gltf_json ~data:("\x00\x00\x80\x7f" ^ String.sub gltf_data 4 152) (), "1:1 SC0320");
    ("glTF, a property that is not known", "t.gltf", gltf_json ~node:",\"scal\":[2,2,2]" (), "1:1 SC0320");
    ("glTF, instances", "t.gltf", gltf_json ~node:",\"extensions\":{\"EXT_mesh_gpu_instancing\":{}}" (),
     "1:1 SC0320");
    ("glTF, data elsewhere", "t.gltf",
     "{\"asset\":{\"version\":\"2.0\"},\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],\
      \"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":1}],\
      \"bufferViews\":[{\"buffer\":0,\"byteLength\":12}],\"buffers\":[{\"byteLength\":12,\"uri\":\"a.bin\"}]}",
     "1:1 SC0320");
  ]
