open Scc_exact
open Text
module J = Gltf_json

(* {1 The two chunks of a GLB file} *)

let u32 text offset = Bytes_of.unsigned ~big_endian:false text offset 4
let json_chunk = 0x4E4F534A
let binary_chunk = 0x004E4942

let chunk ~path text offset =
  let n = String.length text in
  if offset + 8 > n then error_at ~path (min n offset) "the file ends within the head of a chunk"
  else
    let length = u32 text offset in
    if offset + 8 + length > n then
      error_at ~path offset "the chunk promises %d bytes, but the file has only %d more" length (n - offset - 8)
    else Ok (u32 text (offset + 4), String.sub text (offset + 8) length, offset + 8 + length)

let is_binary text = String.length text >= 4 && String.equal (String.sub text 0 4) "glTF"

let parts ~path text =
  if not (is_binary text) then Ok (text, None)
  else if String.length text < 12 then error_at ~path 0 "the file ends within its head of 12 bytes"
  else if u32 text 4 <> 2 then error_at ~path 4 "only version 2 of GLB is read, not %d" (u32 text 4)
  else
    let* kind, json, next = chunk ~path text 12 in
    if kind <> json_chunk then error_at ~path 16 "the first chunk of a GLB file is to be JSON"
    else if next >= String.length text then Ok (json, None)
    else
      let* kind, data, _ = chunk ~path text next in
      Ok (json, if kind = binary_chunk then Some data else None)

(* {1 Places of nodes} *)

let vector a = Vec.make a.(0) a.(1) a.(2)

let numbers_or default name node =
  match J.member name node with
  | None -> Ok default
  | Some list -> J.numbers (Array.length default) list

let of_matrix list =
  (* by columns *)
  let* m = J.numbers 16 list in
  let row i = Vec.make m.(i) m.(4 + i) m.(8 + i) in
  let last = Array.init 4 (fun k -> m.((4 * k) + 3)) in
  if Array.for_all2 Rat.equal last [| Rat.zero; Rat.zero; Rat.zero; Rat.one |] then
    Ok { Affine.linear = Mat.make (row 0) (row 1) (row 2); translation = vector (Array.sub m 12 3) }
  else J.fail list "the last row of the matrix is to be 0 0 0 1"

let of_parts node =
  let zero = Rat.zero and one = Rat.one in
  let* translation = numbers_or [| zero; zero; zero |] "translation" node in
  let* turn = numbers_or [| zero; zero; zero; one |] "rotation" node in
  let* scale = numbers_or [| one; one; one |] "scale" node in
  match Mat.of_quaternion (turn.(3), turn.(0), turn.(1), turn.(2)) with
  | Some m -> Ok { Affine.linear = Mat.mul m (Mat.diagonal (vector scale)); translation = vector translation }
  | None -> J.fail node "the quaternion 0 is no rotation"

let place node =
  match J.member "matrix" node with
  | Some m -> of_matrix m
  | None -> of_parts node

(* {1 Meshes} *)

type file = { data : Gltf_data.t; meshes : J.t array; nodes : J.t array; seen : bool array; soup : Soup.t }

let points = 0
let triangles = 4
let strip = 5
let fan = 6

(* Calls with the corners of each triangle, counter-clockwise from outside. *)
let each_triangle mode corners put =
  let n = Array.length corners in
  let c i = corners.(i) in
  if mode = triangles then
    for k = 0 to (n / 3) - 1 do
      put (c (3 * k)) (c ((3 * k) + 1)) (c ((3 * k) + 2))
    done
  else if mode = strip then
    for k = 0 to n - 3 do
      if k land 1 = 0 then put (c k) (c (k + 1)) (c (k + 2)) else put (c (k + 1)) (c k) (c (k + 2))
    done
  else if mode = fan then
    for k = 1 to n - 2 do
      put (c 0) (c k) (c (k + 1))
    done

let primitive file at p =
  let* () = Gltf_table.check ~kind:"primitive" p in
  let* () = Gltf_data.spend file.data p 1 in
  let* mode = J.index_or triangles "mode" p in
  let* attributes = J.needed "attributes" p in
  let* () = Gltf_table.check ~kind:"attributes" attributes in
  if mode <> points && (mode < triangles || mode > fan) then
    J.fail p "the mesh is made of lines (mode %d), and a solid is made of triangles" mode
  else
    match J.member "POSITION" attributes with
    | None -> J.fail p "the vertices have no positions"
    | Some name ->
      let* positions = Gltf_data.positions file.data name in
      let count = Array.length positions in
      let* corners =
        match J.member "indices" p with
        | Some name -> Gltf_data.indices file.data name ~below:count
        | None -> Ok (Array.init count Fun.id)
      in
      let n = Array.length corners in
      if mode = triangles && n mod 3 <> 0 then J.fail p "%d corners are not whole triangles" n
      else
        let numbers = Array.map (fun v -> Soup.number file.soup (Affine.apply at v)) positions in
        (* A mirror turns counter-clockwise into clockwise. *)
        let mirrored = Affine.mirrors at in
        each_triangle mode corners (fun a b c ->
            let a = numbers.(a) and b = numbers.(b) and c = numbers.(c) in
            if mirrored then Soup.add file.soup a c b else Soup.add file.soup a b c);
        Ok ()

let all f list = Result.map ignore (Result.all f (Array.to_list list))

let mesh file at m =
  let* () = Gltf_table.check ~kind:"mesh" m in
  let* weights = J.items "weights" m in
  let* () =
    let rest w = Result.map (fun w -> Rat.sign w = 0) (J.number w) in
    let* at_rest = Result.all rest (Array.to_list weights) in
    if List.for_all Fun.id at_rest then Ok () else J.fail m "a morphed mesh is not read"
  in
  let* primitives = J.items "primitives" m in
  all (primitive file at) primitives

let max_depth = 1000

let rec node file depth at name =
  let* n, i = J.nth file.nodes ~what:"node" name in
  if file.seen.(i) then J.fail n "the node is used twice, or is inside of itself"
  else if depth > max_depth then J.fail n "nodes are inside of each other more than %d deep" max_depth
  else (
    file.seen.(i) <- true;
    let* () = Gltf_table.check ~kind:"node" n in
    let* own = place n in
    let at = Affine.compose at own in
    if Affine.too_long at then J.fail n "the numbers of the places of nodes inside of each other get too long"
    else
      let* () =
        match (J.member "skin" n, J.member "weights" n, J.member "mesh" n) with
        | Some skin, _, _ -> J.fail skin "a mesh on a skeleton is not read"
        | None, Some weights, _ -> J.fail weights "a morphed mesh is not read"
        | None, None, None -> Ok ()
        | None, None, Some name ->
          let* () = Gltf_data.spend file.data n 1 in
          let* m, _ = J.nth file.meshes ~what:"mesh" name in
          mesh file at m
      in
      let* children = J.items "children" n in
      all (node file (depth + 1) at) children)

(* The nodes that are inside of no other. *)
let roots nodes =
  let inner = Array.make (Array.length nodes) false in
  let mark n =
    let* children = J.items "children" n in
    all (fun c -> Result.map (fun (_, i) -> inner.(i) <- true) (J.nth nodes ~what:"node" c)) children
  in
  let* () = all mark nodes in
  Ok (List.filter (fun i -> not inner.(i)) (List.init (Array.length nodes) Fun.id))

let scene root file =
  let* scenes = J.items "scenes" root in
  let* chosen =
    match J.member "scene" root with
    | Some name -> Result.map (fun (s, _) -> Some s) (J.nth scenes ~what:"scene" name)
    | None -> Ok (if Array.length scenes > 0 then Some scenes.(0) else None)
  in
  match chosen with
  | Some s ->
    let* () = Gltf_table.check ~kind:"scene" s in
    Result.bind (J.items "nodes" s) (all (node file 0 Affine.identity))
  | None when Array.length file.nodes > 0 ->
    let* first = roots file.nodes in
    Result.map ignore (Result.all (fun i -> node file 0 Affine.identity (J.of_index root i)) first)
  | None -> all (mesh file Affine.identity) file.meshes

(* The extensions that are named, if none is needed that is not read. *)
let check_head root =
  let* version = Result.bind (Result.bind (J.needed "asset" root) (J.needed "version")) J.text in
  if not (String.length version >= 2 && String.equal (String.sub version 0 2) "2.") then
    J.fail root "only version 2 of glTF is read, not %s" (quote version)
  else
    let* () = Gltf_table.check ~kind:"glTF" root in
    let* needed = J.items "extensionsRequired" root in
    let one e =
      let* name = J.text e in
      if Gltf_table.required name then Ok () else J.fail e "the extension %s is not read" (quote name)
    in
    let* () = all one needed in
    let* used = J.items "extensionsUsed" root in
    Result.all J.text (Array.to_list used @ Array.to_list needed)

(* Animations of cameras and materials are extensions, and have no target among these. *)
let moving ~path root =
  let* animations = J.items "animations" root in
  let moves channel =
    match Option.bind (J.member "target" channel) (J.member "path") with
    | None -> Ok false
    | Some p -> Result.map (fun p -> List.mem p [ "translation"; "rotation"; "scale"; "weights" ]) (J.text p)
  in
  let any animation =
    let* channels = J.items "channels" animation in
    Result.map (List.exists Fun.id) (Result.all moves (Array.to_list channels))
  in
  let* found = Result.all any (Array.to_list animations) in
  let warning =
    Scc_base.Diag.warning Scc_base.Code.mesh_left_out (Scc_base.Span.of_file path)
      ~hint:"nothing has to be done if this is what is meant"
      "the file has animations, and is read as it is without them"
  in
  Ok (if List.mem true found then [ warning ] else [])

let read ~files ~path text =
  let* json, binary = parts ~path text in
  let* root = J.parse ~path json in
  let* extensions = check_head root in
  let budget = ref (100_000 + (2 * String.length text)) in
  let quantized = List.mem Gltf_table.quantization extensions in
  let* data = Gltf_data.make ~files ~path ~binary ~budget ~quantized root in
  let* meshes = J.items "meshes" root in
  let* nodes = J.items "nodes" root in
  let file = { data; meshes; nodes; seen = Array.make (Array.length nodes) false; soup = Soup.create () } in
  let* () = scene root file in
  let* warnings = moving ~path root in
  Ok (Soup.solid file.soup, warnings)
