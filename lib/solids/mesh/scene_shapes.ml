open Scc_exact
open Scc_geometry
open Scene
module F = Scene_fields

type t = { points : Vec.t array; faces : int array list; cost : int; distance : Rat.t }

let exact points faces =
  let corners = List.fold_left (fun n f -> n + Array.length f) 0 faces in
  { points; faces; cost = Array.length points + corners; distance = Rat.zero }

(* {1 Sets of faces} *)

let coordinates ~path node =
  let rec vectors found = function
    | [] -> Array.of_list (List.rev found)
    | x :: y :: z :: rest -> vectors (ok (Text.coordinates ~path [ x; y; z ]) :: found) rest
    | w :: _ -> bad ~path w "the number of coordinates is not a multiple of three"
  in
  match F.nodes ~path node "coord" with
  | [] -> [||]
  | [ points ] -> (
      match Scene_table.find points.kind.text with
      | Read { role = Points; read; still } ->
        F.check ~path points ~read ~still;
        vectors [] (Option.value (F.words ~path points "point") ~default:[])
      | Read _ | Still | Left_out | Unread _ ->
        unread ~path points.kind
          ~hint:(Scene_table.cure points.kind.text)
          "points in a %s are not read" (Text.quote points.kind.text))
  | _ :: other :: _ -> bad ~path other.kind "a shape has one `coord`, and this is another"

(* Runs of indices, each ended by -1, with the place of their ends. *)
let runs ~path ~count words =
  let rec go found run = function
    | [] -> List.rev (match run with [] -> found | (_, w) :: _ -> (List.rev_map fst run, w) :: found)
    | ({ Text.text = "-1"; _ } as w) :: rest ->
      go (match run with [] -> found | _ :: _ -> (List.rev_map fst run, w) :: found) [] rest
    | w :: rest -> go found ((ok (Text.vertex ~path ~count w), w) :: run) rest
  in
  go [] [] words

let face_set ~path node =
  let points = coordinates ~path node in
  let face (run, (w : Text.word)) =
    match run with
    | _ :: _ :: _ :: _ -> Array.of_list run
    | _ -> bad ~path w "a face needs at least three corners, not %d" (List.length run)
  in
  let index = Option.value (F.words ~path node "coordIndex") ~default:[] in
  exact points (List.map face (runs ~path ~count:(Array.length points) index))

(* Triangles with two equal corners have no area: strips turn corners by them. *)
let proper (f : int array) = f.(0) <> f.(1) && f.(1) <> f.(2) && f.(2) <> f.(0)

let strip run =
  let c = Array.of_list run in
  let one k = if k land 1 = 0 then [| c.(k); c.(k + 1); c.(k + 2) |] else [| c.(k + 1); c.(k); c.(k + 2) |] in
  List.filter proper (List.init (max 0 (Array.length c - 2)) one)

let fan run =
  let c = Array.of_list run in
  List.filter proper (List.init (max 0 (Array.length c - 2)) (fun k -> [| c.(0); c.(k + 1); c.(k + 2) |]))

let groups ~path node size run =
  let c = Array.of_list run in
  if Array.length c mod size <> 0 then
    bad ~path node.kind "%d corners are no whole faces of %d each" (Array.length c) size;
  List.init (Array.length c / size) (fun k -> Array.sub c (size * k) size)

let indices ~path node ~count =
  List.map (fun w -> ok (Text.vertex ~path ~count w)) (Option.value (F.words ~path node "index") ~default:[])

let indexed ~path node size =
  let points = coordinates ~path node in
  exact points (groups ~path node size (indices ~path node ~count:(Array.length points)))

let indexed_runs ~path node faces =
  let points = coordinates ~path node in
  let words = Option.value (F.words ~path node "index") ~default:[] in
  exact points (List.concat_map (fun (run, _) -> faces run) (runs ~path ~count:(Array.length points) words))

module Points = Scc_data.Numbering.Make (Vec)

(* Without an index, each corner has a point of its own: equal ones become one. *)
let welded ~path node =
  let numbering = Points.create () in
  let corners = Array.map (Points.number numbering) (coordinates ~path node) in
  (Array.of_list (Points.keys numbering), Array.to_list corners)

let plain ~path node size =
  let points, corners = welded ~path node in
  exact points (groups ~path node size corners)

let counted ~path node name faces =
  let points, corners = welded ~path node in
  let rec go found corners = function
    | [] ->
      if corners <> [] then bad ~path node.kind "`%s` counts fewer corners than there are points" name;
      List.concat_map faces (List.rev found)
    | w :: counts ->
      let n = ok (Text.integer ~path ~what:"the number of corners" w) in
      let rec take run n rest =
        match rest with
        | c :: rest when n > 0 -> take (c :: run) (n - 1) rest
        | [] when n > 0 -> bad ~path w "`%s` counts more corners than there are points" name
        | rest -> (List.rev run, rest)
      in
      if n < 3 then bad ~path w "a strip or fan has at least three corners, not %d" n;
      let run, rest = take [] n corners in
      go (run :: found) rest counts
  in
  exact points (go [] corners (Option.value (F.words ~path node name) ~default:[]))

(* {1 A grid of heights} *)

(* How far the middles of the diagonals of a square of the grid are from each other: 0 if it is flat. The format
   leaves open which diagonal cuts a bent square. The two ways are that far from each other, and no farther. *)
let bend points f =
  let y k = (points.(f.(k)) : Vec.t).y in
  Rat.mul Rat.half (Rat.abs (Rat.sub (Rat.add (y 0) (y 2)) (Rat.add (y 1) (y 3))))

let grid ~path node =
  let columns = F.integer ~path node "xDimension" ~default:0 in
  let rows = F.integer ~path node "zDimension" ~default:0 in
  let step name = F.number ~path node name ~default:Rat.one in
  let dx = step "xSpacing" and dz = step "zSpacing" in
  let heights = Option.value (F.words ~path node "height") ~default:[] in
  let given = List.length heights in
  if columns < 0 || rows < 0 || (columns > 0 && rows > given / columns) || columns * rows <> given then
    bad ~path node.kind "there are %d heights, and not xDimension times zDimension" given;
  let point i w =
    let along step k = Rat.mul step (Rat.of_int k) in
    Vec.make (along dx (i mod columns)) (ok (Text.coordinate ~path w)) (along dz (i / columns))
  in
  let points = Array.of_list (List.mapi point heights) in
  let face k =
    let i = k mod (columns - 1) and j = k / (columns - 1) in
    let at i j = i + (j * columns) in
    [| at i j; at i (j + 1); at (i + 1) (j + 1); at (i + 1) j |]
  in
  let squares = List.init (max 0 (columns - 1) * max 0 (rows - 1)) face in
  let bent f = Rat.sign (bend points f) > 0 in
  let cut f = if bent f then [ [| f.(0); f.(1); f.(2) |]; [| f.(0); f.(2); f.(3) |] ] else [ f ] in
  let distance = List.fold_left (fun d f -> Rat.max d (bend points f)) Rat.zero squares in
  { (exact points (List.concat_map cut squares)) with distance }

(* {1 Solids} *)

let positive ~path node name default =
  let q = F.number ~path node name ~default in
  if Rat.sign q <= 0 then bad ~path node.kind "`%s` has to be greater than 0" name;
  q

let two = Rat.of_int 2

let box ~path node =
  let size = Option.value (F.numbers ~path node "size" ~count:3) ~default:[| two; two; two |] in
  if Array.exists (fun q -> Rat.sign q <= 0) size then bad ~path node.kind "`size` has to be greater than 0";
  let set = Named_solids.box size.(0) size.(1) size.(2) in
  exact (Array.map snd set.ifs_vertices) (List.map snd (Array.to_list set.ifs_faces))

(* A shape costs as much as its text may be worth, and not as much as it has corners: these are few. *)
let curved points faces distance = { points; faces; cost = 64; distance }
let upward (v : Vec.t) = Vec.make v.y v.z v.x
let near = lazy (Curved.sphere Inscribed Curved.least)
let round = lazy (Curved.disc Inscribed Curved.least)

let sphere ~path node =
  let r = positive ~path node "radius" Rat.one in
  let { Curved.corners; distance; _ } = Lazy.force near in
  let set = Curved.ball corners in
  curved
    (Array.map (fun (_, v) -> upward (Vec.scale r v)) set.ifs_vertices)
    (List.map snd (Array.to_list set.ifs_faces))
    (Rat.mul r distance)

(* The corners of the disc of the radius at a height, counter-clockwise from above. *)
let ring n r y =
  let corner k =
    let c, s = Named_solids.on_circle n k in
    Vec.make (Rat.mul r s) y (Rat.mul r c)
  in
  Array.init n corner

let when_ shown face = if shown then [ face ] else []
let sides shown n face = if shown then List.init n (fun k -> face k ((k + 1) mod n)) else []

let cylinder ~path node =
  let r = positive ~path node "radius" Rat.one in
  let half = Rat.mul Rat.half (positive ~path node "height" two) in
  let shown name = F.truth ~path node name in
  let { Curved.corners = n; distance; _ } = Lazy.force round in
  let faces =
    when_ (shown "bottom") (Array.init n (fun k -> n - 1 - k))
    @ when_ (shown "top") (Array.init n (fun k -> n + k))
    @ sides (shown "side") n (fun k next -> [| k; next; n + next; n + k |])
  in
  curved (Array.append (ring n r (Rat.neg half)) (ring n r half)) faces (Rat.mul r distance)

let cone ~path node =
  let r = positive ~path node "bottomRadius" Rat.one in
  let half = Rat.mul Rat.half (positive ~path node "height" two) in
  let shown name = F.truth ~path node name in
  let { Curved.corners = n; distance; _ } = Lazy.force round in
  let faces =
    when_ (shown "bottom") (Array.init n (fun k -> n - 1 - k))
    @ sides (shown "side") n (fun k next -> [| k; next; n |])
  in
  let apex = Vec.make Rat.zero half Rat.zero in
  curved (Array.append (ring n r (Rat.neg half)) [| apex |]) faces (Rat.mul r distance)

(* {1 All of them} *)

let extrusion ~path ~room node =
  let { Extrusion.points; faces; distance } = Extrusion.make ~path ~room node in
  { (exact points faces) with distance }

let shape ~path ~room node =
  match node.kind.text with
  | "IndexedFaceSet" -> face_set ~path node
  | "IndexedTriangleSet" -> indexed ~path node 3
  | "IndexedQuadSet" -> indexed ~path node 4
  | "IndexedTriangleStripSet" -> indexed_runs ~path node strip
  | "IndexedTriangleFanSet" -> indexed_runs ~path node fan
  | "TriangleSet" -> plain ~path node 3
  | "QuadSet" -> plain ~path node 4
  | "TriangleStripSet" -> counted ~path node "stripCount" strip
  | "TriangleFanSet" -> counted ~path node "fanCount" fan
  | "ElevationGrid" -> grid ~path node
  | "Box" -> box ~path node
  | "Sphere" -> sphere ~path node
  | "Cylinder" -> cylinder ~path node
  | "Cone" -> cone ~path node
  | "Extrusion" -> extrusion ~path ~room node
  | "PointSet" -> exact (coordinates ~path node) []
  | kind -> Scc_base.Bug.fail __POS__ ("no geometry: " ^ kind)

let reversed c =
  let n = Array.length c in
  Array.init n (fun i -> c.(n - 1 - i))

let make ~path ~room node =
  let shape = shape ~path ~room node in
  if F.truth ~path node "ccw" then shape else { shape with faces = List.map reversed shape.faces }
