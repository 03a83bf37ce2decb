(* Random points against the convex parts of a mesh: each is inside one part, or on the border of some, iff it is
   inside the mesh, which is decided from the faces of the mesh alone, exactly, by a ray. And in each plane the
   parts show the area that the mesh has there. Ends with 1 if anything differs.

   dune exec --profile release test/unit/decompose/points.exe -- POINTS FILE...

   Of ten points eight are anywhere in the box around all, one is between corners of a face of the mesh, and one
   between corners of a part, where rays and planes are met. test/bench/decompose --write makes files. *)

open Scc_exact
open Scc_geometry
open Scc_concave

(* (x, y, z) / w, w > 0; and the same in floats, for boxes, that are wide enough for their errors. *)
type point = { x : Z.t; y : Z.t; z : Z.t; w : Z.t; at : float * float }

let point v =
  let (n : Ivec.t), w = Ivec.of_vec v in
  { x = n.x; y = n.y; z = n.z; w; at = (Rat.to_float v.Vec.y, Rat.to_float v.Vec.z) }

(* {1 Planes: above, on or below} *)

type plane = { a : Z.t; b : Z.t; c : Z.t; d : Z.t }

let plane corners =
  let (n : Ivec.t) = Ivec.primitive (fst (Ivec.of_vec (Planes.area_vector corners))) in
  let level = Vec.dot (Ivec.to_vec n) corners.(0) in
  let by = Q.den level in
  { a = Z.mul by n.x; b = Z.mul by n.y; c = Z.mul by n.z; d = Q.num level }

let side p q = Z.sign Z.(sub (add (add (mul p.a q.x) (mul p.b q.y)) (mul p.c q.z)) (mul p.d q.w))

(* {1 Columns of the box along x, with what is in each} *)

let across = 128

type 'a columns = { low : float * float; step : float * float; found : 'a list array }

let column t (y, z) =
  let at v low step = Int.max 0 (Int.min (across - 1) (int_of_float ((v -. low) /. step))) in
  (at y (fst t.low) (fst t.step), at z (snd t.low) (snd t.step))

let slack = 1e-6

let extent points =
  let of_ get = List.map (fun v -> Rat.to_float (get v)) points in
  let least list = List.fold_left Float.min infinity list and most l = List.fold_left Float.max neg_infinity l in
  let ys = of_ (fun (v : Vec.t) -> v.y) and zs = of_ (fun (v : Vec.t) -> v.z) in
  ((least ys -. slack, least zs -. slack), (most ys +. slack, most zs +. slack))

let columns whole members =
  let low, high = extent whole in
  let step = ((fst high -. fst low) /. float across, (snd high -. snd low) /. float across) in
  let t = { low; step; found = Array.make (across * across) [] } in
  let put (corners, x) =
    let from, until = extent corners in
    let i, j = column t from and k, l = column t until in
    for y = i to k do
      for z = j to l do
        t.found.((y * across) + z) <- x :: t.found.((y * across) + z)
      done
    done
  in
  List.iter put members;
  t

let at t q =
  let y, z = column t q.at in
  t.found.((y * across) + z)

(* {1 The mesh} *)

type place = Inside | Border | Outside

(* Seen along x: on which side of the edge from a to b the point is. *)
let turn q (a : point) (b : point) =
  let part r s = Z.sub (Z.mul r.y s.z) (Z.mul r.z s.y) in
  Z.sign Z.(add (mul q.w (part a b)) (add (mul a.w (part b q)) (mul b.w (part q a))))

let higher (a : point) q = Z.compare (Z.mul a.z q.w) (Z.mul q.z a.w) > 0

let on_edge q (a : point) (b : point) =
  let between get =
    let one = Z.compare (Z.mul (get a) q.w) (Z.mul (get q) a.w)
    and other = Z.compare (Z.mul (get b) q.w) (Z.mul (get q) b.w) in
    one * other <= 0
  in
  turn q a b = 0 && between (fun p -> p.y) && between (fun p -> p.z)

(* A face that stands on edge, as seen along x, is looked at along another axis. *)
let shift p = { p with x = p.y; y = p.z; z = p.x }

let rec upright f corners q =
  if Z.sign f.a <> 0 then (corners, q)
  else upright { f with a = f.b; b = f.c; c = f.a } (Array.map shift corners) (shift q)

let covers corners q =
  let n = Array.length corners in
  let odd = ref false and edge = ref false in
  for i = 0 to n - 1 do
    let a = corners.(i) and b = corners.((i + 1) mod n) in
    if on_edge q a b then edge := true;
    let up = higher b q in
    if higher a q <> up && turn q a b * (if up then 1 else -1) > 0 then odd := not !odd
  done;
  (!odd, !edge)

let in_mesh faces q =
  let rec go inside = function
    | [] -> if inside then Inside else Outside
    | (f, corners) :: rest ->
      let s = side f q in
      if s = 0 then
        let corners, q = upright f corners q in
        match covers corners q with
        | false, false -> go inside rest
        | _ -> Border
      else if Z.sign f.a <> 0 && Z.sign f.a * s < 0 && fst (covers corners q) then go (not inside) rest
      else go inside rest
  in
  go false faces

(* {1 The parts} *)

let in_part planes q =
  let rec go border = function
    | [] -> if border then Border else Inside
    | p :: rest ->
      let s = side p q in
      if s > 0 then Outside else go (border || s = 0) rest
  in
  go false planes

let fits place (inside, border) =
  match place with
  | Inside -> (inside = 1 && border = 0) || (inside = 0 && border >= 2)
  | Border -> inside = 0 && border >= 1
  | Outside -> inside = 0 && border = 0

(* {1 Points} *)

let between corners =
  let pick () = corners.(Random.int (Array.length corners)) in
  let weights = List.init 3 (fun _ -> (Random.int 5, pick ())) in
  let sum = List.fold_left (fun n (k, _) -> n + k) 0 weights in
  if sum = 0 then pick ()
  else
    let part (k, v) = Vec.scale (Rat.make (Z.of_int k) (Z.of_int sum)) v in
    List.fold_left (fun s w -> Vec.add s (part w)) Vec.zero weights

let anywhere (low : Vec.t) (high : Vec.t) =
  let parts = 1_000_003 in
  let from l h = Rat.add l (Rat.mul (Rat.make (Z.of_int (Random.int parts)) (Z.of_int parts)) (Rat.sub h l)) in
  let x = from low.x high.x in
  let y = from low.y high.y in
  Vec.make x y (from low.z high.z)

let box points =
  let each f (a : Vec.t) (b : Vec.t) = Vec.make (f a.x b.x) (f a.y b.y) (f a.z b.z) in
  let first = List.hd points in
  (List.fold_left (each Rat.min) first points, List.fold_left (each Rat.max) first points)

(* {1 A mesh} *)

let read path =
  let file = open_in_bin path in
  let text = really_input_string file (in_channel_length file) in
  close_in file;
  match Scc_mesh.Mesh.read ~files:Scc_mesh.Beside.none ~path text with
  | Ok (set, _) -> set
  | Error _ -> failwith (path ^ ": not read")

let check count path =
  let set = read path in
  let t = match Decomposed.make set with Ok t -> t | Error _ -> failwith (path ^ ": not decomposed") in
  let start = Sys.time () in
  let outline (_, corners) = Array.map (fun v -> snd set.Polyhedron.ifs_vertices.(v)) corners in
  let mesh = Array.map outline set.ifs_faces and parts = Array.map snd t.parts in
  let points = List.map snd (Array.to_list set.ifs_vertices) in
  let low, high = box points in
  let face corners = (Array.to_list corners, (plane corners, Array.map point corners)) in
  let corners (p : Polyhedron.t) = Array.map snd p.vertices in
  let part p = (Array.to_list (corners p), List.map plane (Planes.faces p)) in
  let faces = columns points (List.map face (Array.to_list mesh)) in
  let solids = columns points (List.map part (Array.to_list parts)) in
  let wrong = ref 0 and inside = ref 0 and on_mesh = ref 0 and on_parts = ref 0 in
  for k = 1 to count do
    let x =
      match k mod 10 with
      | 0 -> between mesh.(Random.int (Array.length mesh))
      | 1 -> between (corners parts.(Random.int (Array.length parts)))
      | _ -> anywhere low high
    in
    let q = point x in
    let place = in_mesh (at faces q) q in
    let tally (i, b) p =
      match in_part p q with Inside -> (i + 1, b) | Border -> (i, b + 1) | Outside -> (i, b)
    in
    let i, b = List.fold_left tally (0, 0) (at solids q) in
    (match place with
     | Inside -> incr (if i = 0 then on_parts else inside)
     | Border -> incr on_mesh
     | Outside -> ());
    if not (fits place (i, b)) then begin
      incr wrong;
      if !wrong <= 5 then Printf.printf "  WRONG: %s, inside %d and on the border of %d\n" (Vec.to_string x) i b
    end
  done;
  let shown = List.concat_map Planes.faces (Array.to_list parts) in
  let same = Planes.areas (Array.to_list mesh) = Planes.areas shown in
  Printf.printf
    "%s: %d faces, %d parts; %d points, %d inside a part, %d between parts, %d on the surface, %d wrong; areas of \
     planes %s (%.0f s)\n%!"
    path (Array.length mesh) (Array.length parts) count !inside !on_parts !on_mesh !wrong
    (if same then "equal" else "DIFFER")
    (Sys.time () -. start);
  !wrong = 0 && same

let () =
  Random.init 1;
  match Array.to_list Sys.argv with
  | _ :: count :: (_ :: _ as files) ->
    let done_ = List.map (check (int_of_string count)) files in
    exit (if List.for_all Fun.id done_ then 0 else 1)
  | _ ->
    prerr_endline "points.exe POINTS FILE...";
    exit 64
