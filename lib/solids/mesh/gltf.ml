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

let trailing ~path ~stop n =
  let open Scc_base in
  Diag.warning Code.mesh_left_out
    (Span.make ~file:path ~start:stop ~stop)
    "%s after the end that the head promises are left out" (Plural.count (n - stop) "byte" "bytes")

let parts ~path text =
  if not (is_binary text) then Ok (text, None, [])
  else if String.length text < 12 then error_at ~path 0 "the file ends within its head of 12 bytes"
  else if u32 text 4 <> 2 then error_at ~path 4 "only version 2 of GLB is read, not %d" (u32 text 4)
  else
    let* kind, json, next = chunk ~path text 12 in
    if kind <> json_chunk then error_at ~path 16 "the first chunk of a GLB file is to be JSON"
    else
      let length = u32 text 8 and n = String.length text in
      (* Chunks of other kinds are for programs that know them. *)
      let rec others at =
        if at >= length then Ok at
        else match chunk ~path text at with Ok (_, _, next) -> others next | Error _ as e -> e
      in
      let* binary, next =
        if next >= length then Ok (None, next)
        else
          let* kind, data, next = chunk ~path text next in
          Ok ((if kind = binary_chunk then Some data else None), next)
      in
      let* stop = others next in
      if stop <> length || length > n then
        error_at ~path 8 "the head promises a file of %d bytes, but its chunks end at %d" length stop
      else Ok (json, binary, if n > length then [ trailing ~path ~stop n ] else [])

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
  let length2 = Array.fold_left (fun sum x -> Rat.add sum (Rat.mul x x)) zero turn in
  let unit = Rat.compare (Rat.abs (Rat.sub length2 one)) (Rat.make Z.one (Z.of_int 50)) <= 0 in
  match Mat.of_quaternion (turn.(3), turn.(0), turn.(1), turn.(2)) with
  | Some m when unit ->
    Ok { Affine.linear = Mat.mul m (Mat.diagonal (vector scale)); translation = vector translation }
  | Some _ | None -> J.fail node "the rotation is no quaternion of length 1"

let place node =
  match J.member "matrix" node with
  | None -> of_parts node
  | Some m ->
    let is_there name = Option.is_some (J.member name node) in
    (match List.find_opt is_there [ "translation"; "rotation"; "scale" ] with
     | None -> of_matrix m
     | Some other -> J.fail node "the node has a matrix and a %s: one of both is to be removed" other)

(* {1 Meshes} *)

type file = {
  data : Gltf_data.t;
  meshes : J.t array;
  nodes : J.t array;
  materials : J.t array;
  cameras : J.t array;
  seen : bool array;
  soup : Soup.t;
  mutable alone : string option;  (* where the first points without faces are *)
  mutable hidden : string option;  (* a node of which nothing is shown *)
}

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

(* Moves the points of a primitive by its displacements, each by its weight. *)
let morph file p ~weights positions =
  let* targets = J.items "targets" p in
  let n = Array.length positions in
  let add (k, target) =
    let* () = Gltf_table.check ~kind:"target" target in
    match J.member "POSITION" target with
    | None -> Ok ()
    | Some name ->
      let* by = Gltf_data.positions file.data name in
      if Array.length by <> n then J.fail name "%d displacements are for %d vertices" (Array.length by) n
      else
        let weight = if k < Array.length weights then weights.(k) else Rat.zero in
        Array.iteri (fun i d -> positions.(i) <- Vec.add positions.(i) (Vec.scale weight d)) by;
        Ok ()
  in
  if Array.length weights > 0 && Array.length weights <> Array.length targets then
    J.fail p "there are %d weights for %d targets" (Array.length weights) (Array.length targets)
  else Result.map ignore (Result.all add (List.mapi (fun k t -> (k, t)) (Array.to_list targets)))

let check_compressed file p attributes =
  match Option.bind (J.member "extensions" p) (J.member Gltf_table.draco) with
  | None -> Ok ()
  | Some _ ->
    let names = List.filter_map Fun.id [ J.member "POSITION" attributes; J.member "indices" p ] in
    Result.map ignore (Result.all (Gltf_data.has_data file.data) names)

(* What a member names is to be there, although it moves nothing. *)
let check_there list ~what name holder =
  match J.member name holder with None -> Ok () | Some v -> Result.map ignore (J.nth list ~what v)

let primitive file at ~weights p =
  let* () = Gltf_table.check ~kind:"primitive" p in
  let* () = check_there file.materials ~what:"material" "material" p in
  let* () = Gltf_data.spend file.data p 1 in
  let* mode = J.index_or triangles "mode" p in
  let* attributes = J.needed "attributes" p in
  let* () = Gltf_table.check ~kind:"attributes" attributes in
  let* () = check_compressed file p attributes in
  if mode <> points && (mode < triangles || mode > fan) then
    if mode > fan then J.fail p "there is no mode %d: modes are 0 to 6" mode
    else J.fail p "the mesh is made of lines (mode %d), and a solid is made of triangles" mode
  else
    match J.member "POSITION" attributes with
    | None -> J.fail p "the vertices have no positions"
    | Some name ->
      let* positions = Gltf_data.positions file.data name in
      let* () = morph file p ~weights positions in
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
        if mode = points && Option.is_none file.alone then file.alone <- Some (J.place p);
        (* A mirror turns counter-clockwise into clockwise. *)
        let mirrored = Affine.mirrors at in
        each_triangle mode corners (fun a b c ->
            let a = numbers.(a) and b = numbers.(b) and c = numbers.(c) in
            if mirrored then Soup.add file.soup a c b else Soup.add file.soup a b c);
        Ok ()

let all f list = Result.map ignore (Result.all f (Array.to_list list))

let weights v =
  let* list = J.items "weights" v in
  Result.map Array.of_list (Result.all J.number (Array.to_list list))

(* [shape]: the weights of the node, if it has some; they count before those of the mesh. *)
let mesh file at ~shape m =
  let* () = Gltf_table.check ~kind:"mesh" m in
  let* own = weights m in
  let* primitives = J.items "primitives" m in
  all (primitive file at ~weights:(if Array.length shape > 0 then shape else own)) primitives

let is_hidden node =
  match Option.bind (J.member "extensions" node) (J.member Gltf_table.visibility) with
  | None -> Ok false
  | Some v ->
    let* () = J.is_object v in
    if Option.is_some (J.member "visible" v) then Result.map not (J.truth "visible" v) else Ok false

let max_depth = 1000

(* By the specification, what is scaled to a point is not shown. *)
let nothing = Mat.diagonal Vec.zero

let rec node file depth at name =
  let* n, i = J.nth file.nodes ~what:"node" name in
  if file.seen.(i) then J.fail n "the node is used twice, or is inside of itself"
  else if depth > max_depth then J.fail n "nodes are inside of each other more than %d deep" max_depth
  else (
    file.seen.(i) <- true;
    let* () = Gltf_table.check ~kind:"node" n in
    let* () = check_there file.cameras ~what:"camera" "camera" n in
    let* own = place n in
    let at = Affine.compose at own in
    let* hidden = is_hidden n in
    let* shape = weights n in
    let* children = J.items "children" n in
    if hidden || Mat.equal at.Affine.linear nothing then (
      if Option.is_none file.hidden then
        file.hidden <- Some (J.place n ^ if hidden then " is hidden" else " is scaled to a point");
      Ok ())
    else if Rat.sign (Mat.det at.Affine.linear) = 0 && Option.is_some (J.member "mesh" n) then
      J.fail n "a scale of 0 makes everything flat"
    else if Affine.too_long at then
      J.fail n "the numbers of the places of nodes inside of each other get too long"
    else
      let* () =
        match J.member "mesh" n with
        | None -> Ok ()
        | Some name ->
          let* () = Gltf_data.spend file.data n 1 in
          let* m, _ = J.nth file.meshes ~what:"mesh" name in
          mesh file at ~shape m
      in
      all (node file (depth + 1) at) children)

(* For each node, whether it is inside of another. *)
let inner nodes =
  let inner = Array.make (Array.length nodes) false in
  let mark n =
    let* children = J.items "children" n in
    all (fun c -> Result.map (fun (_, i) -> inner.(i) <- true) (J.nth nodes ~what:"node" c)) children
  in
  Result.map (fun () -> inner) (all mark nodes)

(* The scene that is shown, and what is left out. *)
let chosen root =
  let* scenes = J.items "scenes" root in
  let n = Array.length scenes in
  let others = Scc_base.Plural.count (n - 1) "other scene" "other scenes" in
  match J.member "scene" root with
  | Some name ->
    let* s, _ = J.nth scenes ~what:"scene" name in
    Ok (Some s, if n > 1 then [ others ^ " of the file are left out" ] else [])
  | None when n = 0 -> Ok (None, [])
  | None when n = 1 -> Ok (Some scenes.(0), [])
  | None -> Ok (Some scenes.(0), [ "no scene is the default: the first is read, and " ^ others ^ " are left out" ])

let scene root file =
  let* shown, left_out = chosen root in
  let* inner = inner file.nodes in
  let outermost name =
    let* n, i = J.nth file.nodes ~what:"node" name in
    if inner.(i) then J.fail n "the node is in a scene, and inside of another node"
    else node file 0 Affine.identity name
  in
  let* () =
    match shown with
    | Some s ->
      let* () = Gltf_table.check ~kind:"scene" s in
      Result.bind (J.items "nodes" s) (all outermost)
    | None when Array.length file.nodes > 0 ->
      let first = List.filter (fun i -> not inner.(i)) (List.init (Array.length file.nodes) Fun.id) in
      Result.map ignore (Result.all (fun i -> node file 0 Affine.identity (J.of_index root i)) first)
    | None -> all (mesh file Affine.identity ~shape:[||]) file.meshes
  in
  Ok left_out

(* The extensions that are named, if none is needed that is not read. *)
let check_head root =
  let* asset = J.needed "asset" root in
  let* version = Result.bind (J.needed "version" asset) J.text in
  let* least = Option.fold ~none:(Ok "2.0") ~some:J.text (J.member "minVersion" asset) in
  if not (String.length version >= 2 && String.equal (String.sub version 0 2) "2.") then
    J.fail root "only version 2 of glTF is read, not %s" (quote version)
  else if not (String.equal least "2.0") then J.fail asset "only version 2.0 of glTF is read, not %s" (quote least)
  else
    let* () = Gltf_table.check ~kind:"asset" asset in
    let* () = Gltf_table.check ~kind:"glTF" root in
    let* needed = J.items "extensionsRequired" root in
    let one e =
      let* name = J.text e in
      if Gltf_table.required name then Ok () else J.fail e "the extension %s is not read" (quote name)
    in
    let* () = all one needed in
    let* used = J.items "extensionsUsed" root in
    Result.all J.text (Array.to_list used @ Array.to_list needed)

(* A pointer names any property; those of materials, lights and cameras move nothing. *)
let pointer_moves goal =
  match Option.bind (J.member "extensions" goal) (J.member "KHR_animation_pointer") with
  | None -> Ok true
  | Some v ->
    let* pointer = Result.bind (J.needed "pointer" v) J.text in
    let still prefix = String.starts_with ~prefix pointer in
    Ok (not (List.exists still [ "/materials/"; "/cameras/"; "/extensions/KHR_lights_punctual/" ]))

let channel_moves channel =
  let* () = Gltf_table.check ~kind:"channel" channel in
  let* goal = J.needed "target" channel in
  let* () = Gltf_table.check ~kind:"goal" goal in
  let* path = Result.bind (J.needed "path" goal) J.text in
  let* node = Option.fold ~none:(Ok (-1)) ~some:J.index (J.member "node" goal) in
  if String.equal path "pointer" then pointer_moves goal else Ok (node >= 0)

let moving root =
  let* animations = J.items "animations" root in
  let any animation =
    let* () = Gltf_table.check ~kind:"animation" animation in
    let* channels = J.items "channels" animation in
    Result.map (List.exists Fun.id) (Result.all channel_moves (Array.to_list channels))
  in
  let* found = Result.all any (Array.to_list animations) in
  Ok (if List.mem true found then [ "the file has animations, and is read as it is without them" ] else [])

(* Points are a cloud if there is nothing else. *)
let points_alone file (set : Scc_geometry.Polyhedron.ifs) =
  match file.alone with
  | Some at when Array.length set.ifs_faces > 0 -> [ at ^ ": points without faces bound no solid" ]
  | Some _ | None -> []

let of_whole_file root =
  match Gltf_table.undeclared root with
  | Some name -> [ "the extension " ^ quote name ^ " of the whole file is left out" ]
  | None -> []

let read ~files ~path text =
  let* json, binary, trailing = parts ~path text in
  let* root = J.parse ~path json in
  let* extensions = check_head root in
  let budget = ref (100_000 + (2 * String.length text)) in
  let quantized = List.mem Gltf_table.quantization extensions in
  let* data = Gltf_data.make ~files ~path ~binary ~budget ~quantized root in
  let* meshes = J.items "meshes" root in
  let* nodes = J.items "nodes" root in
  let* materials = J.items "materials" root in
  let* cameras = J.items "cameras" root in
  let seen = Array.make (Array.length nodes) false in
  let file =
    { data; meshes; nodes; materials; cameras; seen; soup = Soup.create (); alone = None; hidden = None }
  in
  let* others = scene root file in
  let* moving = moving root in
  let warning what =
    Scc_base.Diag.warning Scc_base.Code.mesh_left_out (Scc_base.Span.of_file path)
      ~hint:"nothing has to be done if this is what is meant" "%s" what
  in
  let set = Soup.solid file.soup in
  let* () =
    match file.hidden with
    | _ when Array.length set.ifs_vertices > 0 -> Ok ()
    | Some why -> J.fail root "the scene shows no faces: %s" why
    | None -> J.fail root "the scene shows no faces: there is no mesh in it"
  in
  let odd = Option.to_list (Gltf_data.odd file.data) in
  let all = others @ points_alone file set @ odd @ moving @ of_whole_file root in
  Ok (set, List.map warning all @ trailing)
