open Scc_exact
open Scene
module F = Scene_fields

type t = { points : Vec.t array; faces : int array list; distance : Rat.t }

(* {1 Fields} *)

(* The values of a field with [size] numbers each. *)
let values ~path node name size default =
  match F.words ~path node name with
  | None -> Array.map (Array.map Rat.of_int) default
  | Some words ->
    let numbers = Array.of_list (List.map (fun w -> ok (Text.coordinate ~path w)) words) in
    if Array.length numbers mod size <> 0 then
      bad ~path (F.place node name) "the number of values of `%s` is not a multiple of %d" name size;
    Array.init (Array.length numbers / size) (fun k -> Array.sub numbers (size * k) size)

(* One value for each point of the spine, or one for all. *)
let for_each ~path node name ~count all =
  let n = Array.length all in
  if n = 1 then fun _ -> all.(0)
  else if n >= count then fun i -> all.(i)
  else
    bad ~path (F.place node name) "`%s` has %d values: expected one, or one for each of the %d points of the spine"
      name n count

let vector (v : Rat.t array) = Vec.make v.(0) v.(1) v.(2)

(* {1 Frames along the spine} *)

(* [off]: none of the axes is farther from its place. *)
type frame = { x : Vec.t; y : Vec.t; z : Vec.t; off : Rat.t }

let quantum = Rat.power_of_two (-40)

(* The vector of length 1, and how far it may be off: roots are off by less than 2^-38 of themselves, and the three
   coordinates by 2^-41 more. *)
let unit (v : Vec.t) =
  let square = Vec.norm2 v in
  let length = Rat.root square in
  let exact = Vec.scale (Rat.div Rat.one length) v in
  if Rat.equal (Rat.mul length length) square then (exact, Rat.zero)
  else
    let round q = Rat.round_to q ~quantum in
    (Vec.make (round exact.x) (round exact.y) (round exact.z), Rat.power_of_two (-37))

let unclear ~path node what =
  unread ~path (F.place node "spine")
    ~hint:"draw it upwards, without equal points beside each other, or export the scene with triangles"
    "the spine %s: where its cross sections stand is left open" what

(* The shortest turn of (0, 1, 0) into a direction. With 1 + y >= 1/8, the axes are off by less than 128 times what
   the direction is off: the derivatives of x^2 / (1 + y), and so on, are 32 at most. *)
let straight ~path node direction =
  let d, off = unit direction in
  let below = Rat.add Rat.one d.y in
  let steep = if Rat.sign off = 0 then Rat.zero else Rat.make Z.one (Z.of_int 8) in
  if Rat.sign below <= 0 || Rat.compare below steep < 0 then unclear ~path node "points downwards";
  let over a b = Rat.div (Rat.mul a b) below in
  {
    x = Vec.make (Rat.sub Rat.one (over d.x d.x)) (Rat.neg d.x) (Rat.neg (over d.x d.z));
    y = d;
    z = Vec.make (Rat.neg (over d.x d.z)) (Rat.neg d.z) (Rat.sub Rat.one (over d.z d.z));
    off = Rat.mul (Rat.of_int 128) off;
  }

(* The points before and after each one; at the ends of an open spine, the end itself. *)
let neighbours spine ~closed i =
  let n = Array.length spine in
  let last = n - 1 in
  if closed && (i = 0 || i = last) then (spine.(n - 2), spine.(1))
  else (spine.(max 0 (i - 1)), spine.(min last (i + 1)))

(* Normals of neighbours, each turned to the side of the one before. Where three points are in line it is that of
   the point before, or of the first point that has one. *)
let normals spine ~closed =
  let cross i =
    let before, after = neighbours spine ~closed i in
    Vec.cross (Vec.sub after spine.(i)) (Vec.sub before spine.(i))
  in
  let own = Array.init (Array.length spine) cross in
  let first = List.find_opt (fun v -> not (Vec.is_zero v)) (Array.to_list own) in
  let next before v =
    if Vec.is_zero v then before else if Rat.sign (Vec.dot before v) < 0 then Vec.neg v else v
  in
  let side = ref (Option.value first ~default:Vec.zero) in
  Array.map
    (fun v ->
       side := next !side v;
       !side)
    own

let bent ~path node spine ~closed =
  let normals = normals spine ~closed in
  let last = Array.length spine - 1 in
  let frame i =
    let before, after = neighbours spine ~closed i in
    let along = Vec.sub after before in
    if Vec.is_zero along then unclear ~path node "turns back";
    let y, off_y = unit along and z, off_z = unit normals.(i) in
    (* The product of two axes that are off by less than 2^-37 each is off by less than 2^-35. *)
    let off = if Rat.sign off_y = 0 && Rat.sign off_z = 0 then Rat.zero else Rat.power_of_two (-35) in
    { x = Vec.cross y z; y; z; off }
  in
  let frames = Array.init (Array.length spine) frame in
  if closed then frames.(last) <- frames.(0);
  frames

let frames ~path node spine =
  let n = Array.length spine in
  let steps = Array.init (n - 1) (fun i -> Vec.sub spine.(i + 1) spine.(i)) in
  if Array.exists Vec.is_zero steps then unclear ~path node "has equal points beside each other";
  let collinear v = Vec.is_zero (Vec.cross steps.(0) v) in
  if Array.for_all collinear steps then begin
    if Array.exists (fun v -> Rat.sign (Vec.dot steps.(0) v) < 0) steps then unclear ~path node "turns back";
    Array.make n (straight ~path node steps.(0))
  end
  else bent ~path node spine ~closed:(n > 2 && Vec.equal spine.(0) spine.(n - 1))

(* {1 Cross sections} *)

(* The points of one cross section, and how far they may be off. A point at the distance r from the spine is off by
   the bound of its own turn times r, and by that of the axes times the sum of its coordinates. *)
let section ~path node (frame : frame) at scale turn curve =
  if Array.exists (fun q -> Rat.sign q < 0) scale then
    bad ~path (F.place node "scale") "`scale` has to be 0 or more";
  let turned, off =
    match Turn.rotation (vector turn) turn.(3) with
    | Some found -> found
    | None ->
      bad ~path (F.place node "orientation")
        "`orientation` turns about an axis of length 0, or by an angle beyond 10^6"
  in
  let one c =
    let flat = Vec.make (Rat.mul scale.(0) c.(0)) Rat.zero (Rat.mul scale.(1) c.(1)) in
    let v = Mat.apply turned flat in
    let place = Vec.axpy v.x frame.x (Vec.axpy v.y frame.y (Vec.axpy v.z frame.z at)) in
    let size = Rat.add (Rat.abs flat.x) (Rat.abs flat.z) in
    (place, Rat.mul (Rat.mul (Rat.of_int 2) (Rat.add off frame.off)) size)
  in
  Array.map one curve

(* {1 Faces} *)

(* Corners without those that are equal to the next one: scales of 0 bring points together. *)
let simple (f : int array) =
  let n = Array.length f in
  let kept = List.filter (fun k -> f.(k) <> f.((k + 1) mod n)) (List.init n Fun.id) in
  Array.of_list (List.map (fun k -> f.(k)) kept)

(* A side as faces, and the distance of the two ways to cut it. *)
let side points f =
  let p k = points.(f.(k)) in
  let planar () =
    let normal = Vec.cross (Vec.sub (p 2) (p 0)) (Vec.sub (p 3) (p 1)) in
    Rat.sign (Vec.dot normal (Vec.sub (p 1) (p 0))) = 0
  in
  if Array.length f < 3 then ([], Rat.zero)
  else if Array.length f < 4 || planar () then ([ f ], Rat.zero)
  else
    let middles = Vec.sub (Vec.middle (p 0) (p 2)) (Vec.middle (p 1) (p 3)) in
    ([ [| f.(0); f.(1); f.(2) |]; [| f.(0); f.(2); f.(3) |] ], Rat.root (Vec.norm2 middles))

let caps ~path node (rings : int array array) =
  let last = Array.length rings - 1 in
  let shown name = F.truth ~path node name in
  let start = shown "beginCap" and stop = shown "endCap" in
  let count = Array.length rings.(0) in
  let cap there f =
    let f = simple f in
    if there && Array.length f >= 3 then [ f ] else []
  in
  if start && stop && rings.(0) = rings.(last) then []
  else cap start (Array.init count (fun k -> rings.(0).(count - 1 - k))) @ cap stop rings.(last)

module Points = Scc_data.Numbering.Make (Vec)

let surface ~path node ~closed sections off =
  let numbering = Points.create () in
  let rings = Array.map (Array.map (fun (v, _) -> Points.number numbering v)) sections in
  let points = Array.of_list (Points.keys numbering) in
  let count = Array.length rings.(0) in
  let bent = ref Rat.zero in
  let of_side i k =
    let next = (k + 1) mod count in
    let here = rings.(i) and there = rings.(i + 1) in
    let faces, d = side points (simple [| here.(k); here.(next); there.(next); there.(k) |]) in
    bent := Rat.max !bent d;
    faces
  in
  let along i = List.concat (List.init (if closed then count else count - 1) (of_side i)) in
  let sides = List.concat (List.init (Array.length rings - 1) along) in
  { points; faces = sides @ caps ~path node rings; distance = Rat.add !bent (Rat.mul (Rat.of_int 3) off) }

let make ~path ~room node =
  let all name size default = values ~path node name size default in
  let curve = all "crossSection" 2 [| [| 1; 1 |]; [| 1; -1 |]; [| -1; -1 |]; [| -1; 1 |]; [| 1; 1 |] |] in
  let spine = Array.map vector (all "spine" 3 [| [| 0; 0; 0 |]; [| 0; 1; 0 |] |]) in
  let n = Array.length spine and count = Array.length curve in
  if n < 2 || count < 2 then bad ~path node.kind "spine and cross section need at least two points each";
  if count > room / n then spend ~path (ref 0) node.kind 1;
  let closed = Rat.equal curve.(0).(0) curve.(count - 1).(0) && Rat.equal curve.(0).(1) curve.(count - 1).(1) in
  let curve = if closed then Array.sub curve 0 (count - 1) else curve in
  let scale = for_each ~path node "scale" ~count:n (all "scale" 2 [| [| 1; 1 |] |]) in
  let turn = for_each ~path node "orientation" ~count:n (all "orientation" 4 [| [| 0; 0; 1; 0 |] |]) in
  let frames = frames ~path node spine in
  let one i = section ~path node frames.(i) spine.(i) (scale i) (turn i) curve in
  let sections = Array.init n one in
  let off = Array.fold_left (Array.fold_left (fun d (_, off) -> Rat.max d off)) Rat.zero sections in
  surface ~path node ~closed sections off
