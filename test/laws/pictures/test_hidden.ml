(* What a picture shows at a point is what a ray hits first that comes from whoever looks. The ray is cut by the
   planes of all faces, in rationals, and shares nothing with the library but the axes of the camera. *)

open Scc_exact
open Scc_picture
open Solids

let q = Rat.of_int

(* {1 Scenes} *)

type scene = {
  bodies : (body * Vec.t) list;
  from : Vec.t;
  far : Vec.t;  (** where all of it is *)
  away : Rat.t option;  (** how far the eye is along [from]; infinitely *)
}

let show s =
  let body ((b : body), at) =
    let m = b.turn in
    Printf.sprintf "%s %s at %s" b.name
      (String.concat "" (List.map Vec.to_string [ m.r0; m.r1; m.r2 ]))
      (Vec.to_string at)
  in
  let away = match s.away with None -> "" | Some a -> Printf.sprintf " times %s" (Rat.to_string a) in
  Printf.sprintf "from %s%s, far %s: %s" (Vec.to_string s.from) away (Vec.to_string s.far)
    (String.concat "; " (List.map body s.bodies))

let stands s ((b : body), at) = placed b (Vec.add s.far at)

(* Those that do not interpenetrate with one before. *)
let apart s =
  let fits kept one =
    List.for_all (fun other -> Naive.relation (stands s one) (stands s other) <> Interpenetrating) kept
  in
  let add kept one = if fits kept one then one :: kept else kept in
  { s with bodies = List.rev (List.fold_left add [] s.bodies) }

let direction =
  let some = Gen.map (fun (x, y, z) -> Vec.of_ints x y z) Gen.(triple (-3 -- 3) (-3 -- 3) (-3 -- 3)) in
  Gen.map (fun d -> if Vec.is_zero d then Vec.of_ints 1 2 3 else d) some

let far = Gen.oneofl [ Vec.zero; Vec.of_ints 1_000_000 (-1_000_000) 1_000_000; halves (3, 5, 2_000_001) ]
let make_scene bodies (from, far) = { bodies; from; far; away = None }

let crossing =
  let one = Gen.pair body (Gen.map halves Gen.(triple (-7 -- 7) (-7 -- 7) (-7 -- 7))) in
  Gen.map2 make_scene (Gen.list_size Gen.(2 -- 7) one) (Gen.pair direction far)

let scattered = Gen.map apart crossing

(* Boxes on a grid touch, and much of what is seen of them lies in one line. *)
let stacked =
  let solid = Gen.oneofl [ ("cube", cube); ("slab", slab); ("plank", plank); ("octahedron", octahedron) ] in
  let body = Gen.map2 (fun (name, plain) turn -> { name; plain; turn }) solid (Gen.oneofl cube_turns) in
  let place = Gen.map (fun (x, y, z) -> Vec.of_ints x y z) Gen.(triple (-3 -- 3) (-3 -- 3) (-3 -- 3)) in
  let some = Gen.list_size Gen.(3 -- 12) (Gen.pair body place) in
  Gen.map apart (Gen.map2 make_scene some (Gen.pair direction far))

(* From beside all of it, and from among it: what is behind the eye is cut off. *)
let from_an_eye gen =
  let away = Gen.oneofl [ q 12; Rat.make (Z.of_int 7) (Z.of_int 3); q 1; Rat.make Z.one (Z.of_int 4) ] in
  Gen.map2 (fun s a -> { s with away = Some a }) gen away

(* {1 The ray} *)

let cross_of (s : Naive.solid) face =
  match List.map (fun c -> s.points.(c)) face with
  | a :: b :: c :: _ -> (Vec.cross (Vec.sub b a) (Vec.sub c a), a)
  | _ -> assert false

(* How far along the ray, at most, the solid is, and the faces that end it there. *)
let exit_of (s : Naive.solid) origin towards =
  let cut (low, high, faces) (i, face) =
    let n, a = cross_of s face in
    let height = Vec.dot n (Vec.sub a origin) and slope = Vec.dot n towards in
    match Rat.sign slope with
    | 0 -> if Rat.sign height > 0 then (low, high, faces) else (Some (q 1), Some (q 0), [])
    | sign ->
      let t = Rat.div height slope in
      if sign > 0 then
        match high with
        | Some h when Rat.compare h t < 0 -> (low, high, faces)
        | Some h when Rat.equal h t -> (low, high, i :: faces)
        | _ -> (low, Some t, [ i ])
      else ((match low with Some l when Rat.compare l t > 0 -> low | _ -> Some t), high, faces)
  in
  let numbered = List.mapi (fun i f -> (i, f)) s.faces in
  match List.fold_left cut (None, None, []) numbered with
  | Some low, Some high, faces when Rat.compare low high < 0 -> Some (high, faces)
  | _ -> None

type answer = Nothing | Face of int * int | Unclear

let frontmost ?(among = fun _ -> true) ?limit solids origin towards =
  let behind t = match limit with None -> false | Some l -> Rat.compare t l > 0 in
  let better answer (i, s) =
    match exit_of s origin towards with
    | None -> answer
    | Some (t, _) when behind t -> answer
    | Some (t, faces) -> (
        let here = match faces with [ f ] -> Face (i, f) | _ -> Unclear in
        match answer with
        | Some (best, _) when Rat.compare best t > 0 -> answer
        | Some (best, _) when Rat.equal best t -> Some (t, Unclear)
        | _ -> Some (t, here))
  in
  let numbered = List.filter (fun (i, _) -> among i) (List.mapi (fun i s -> (i, s)) solids) in
  match List.fold_left better None numbered with None -> Nothing | Some (_, answer) -> answer

(* {1 The picture} *)

type seen = { scene : scene; camera : Camera.t; origin : Ivec.t; hidden : Hidden.t; pieces : Convex.t list array }

let least = Rat.make Z.one (Z.of_int 10)

let see ?glass s =
  let straight = Camera.make s.from in
  let from away = Camera.with_eye straight { at = Vec.axpy away (Ivec.to_vec straight.near) s.far; least } in
  let camera = Option.fold s.away ~none:straight ~some:from in
  let origin, d = Ivec.of_vec s.far in
  let origin = if Z.equal d Z.one then origin else Ivec.zero in
  let solid id ((b : body), at) =
    View.of_placed { solid = solid ~id b; turned = Quaternion.identity; at = Vec.add s.far at }
  in
  let hidden = Hidden.make ?glass (View.make camera ~origin (Array.of_list (List.mapi solid s.bodies))) in
  { scene = s; camera; origin; hidden; pieces = Hidden.all_pieces hidden }

(* The point of space at a point of the picture, or how a ray from there goes away from an eye. *)
let in_space v x y =
  let along axis c =
    let a = Ivec.to_vec axis in
    Vec.scale (Rat.div c (Vec.norm2 a)) a
  in
  Vec.add (along v.camera.right x) (along v.camera.up y)

let hit ?among v x y =
  let solids = List.map (stands v.scene) v.scene.bodies and near = Ivec.to_vec v.camera.near in
  match v.camera.eye with
  | None -> frontmost ?among solids (Vec.add (Ivec.to_vec v.origin) (in_space v x y)) near
  | Some eye ->
    (* A unit of this ray is one unit along the axis to the eye, times its length. *)
    let towards = Vec.sub (Vec.scale (Rat.div Rat.one (Vec.norm2 near)) near) (in_space v x y) in
    let limit = Rat.neg (Rat.mul least (Camera.length_near v.camera)) in
    frontmost ?among ~limit solids eye.at towards

let name v i =
  let f = (Hidden.view v.hidden).faces.(i) in
  (f.body, f.face)

let homogeneous x y =
  let n, w = Ivec.of_vec (Vec.make x y Rat.one) in
  Convex.point n.x n.y w

let drawn v x y =
  let p = homogeneous x y in
  let here pieces = List.exists (fun c -> Convex.contains c p) pieces in
  List.filter (fun i -> here v.pieces.(i)) (List.init (Array.length v.pieces) Fun.id)

(* What is drawn at the point is what the ray hits; on a line where faces meet, any of them may be. *)
let right v (x, y) =
  match (hit v x y, drawn v x y) with
  | Unclear, _ -> true
  | Nothing, [] -> true
  | Face (b, f), [ i ] -> name v i = (b, f) && Hidden.front v.hidden (homogeneous x y) = Some i
  | Face (b, f), (_ :: _ as several) -> List.exists (fun i -> name v i = (b, f)) several
  | Nothing, _ :: _ | Face _, [] -> false

let corners v = List.concat_map Array.to_list (Array.to_list (Hidden.view v.hidden).points)

(* Points over the picture, at places that no corner is likely to have. *)
let somewhere v numbers =
  let places = List.map Convex.place (corners v) in
  if places = [] then [] else
    let extent f = (List.fold_left (fun m p -> Rat.min m (f p)) (f (List.hd places)) places,
                    List.fold_left (fun m p -> Rat.max m (f p)) (f (List.hd places)) places) in
    let within (low, high) n = Rat.add low (Rat.mul (Rat.sub high low) (Rat.make (Z.of_int n) (Z.of_int 9973))) in
    List.map (fun (a, b) -> (within (extent fst) a, within (extent snd) b)) numbers

(* Not at the ends of the picture: there a ray only grazes what it meets. *)
let anywhere = Gen.list_size (Gen.return 25) Gen.(pair (1 -- 9972) (1 -- 9972))

let at_random (s, numbers) =
  let v = see s in
  List.for_all (right v) (somewhere v numbers)

(* With every second solid of glass, a ray that passes through glass hits what is drawn of the others, and glass is
   drawn where a ray hits it first. *)
let through_glass (s, numbers) =
  let glass i = i mod 2 = 0 in
  let v = see ~glass s in
  let agrees answer some ~front p =
    match (answer, some) with
    | Unclear, _ -> true
    | Nothing, drawn -> drawn = []
    | Face (b, f), drawn ->
      List.exists (fun i -> name v i = (b, f)) drawn
      && (List.compare_length_with drawn 1 > 0 || (not front) || Hidden.front v.hidden p = Some (List.hd drawn))
  in
  let at (x, y) =
    let through, others = List.partition (fun i -> glass (fst (name v i))) (drawn v x y) in
    let first = match hit v x y with Face (b, _) when not (glass b) -> Nothing | answer -> answer in
    agrees (hit ~among:(fun i -> not (glass i)) v x y) others ~front:true (homogeneous x y)
    && agrees first through ~front:false (homogeneous x y)
  in
  List.for_all at (somewhere v numbers)

(* The middle of each piece is a point of it, and so what is hit there is known beforehand. *)
let in_the_middle (s, _) =
  let v = see s in
  let all i pieces =
    List.for_all
      (fun piece ->
         let x, y = Convex.place (Convex.middle piece) in
         match hit v x y with Face (b, f) -> name v i = (b, f) | Unclear -> true | Nothing -> false)
      pieces
  in
  Array.for_all Fun.id (Array.mapi all v.pieces)

(* Nothing is drawn twice. *)
let disjoint (s, _) =
  let v = see s in
  let all = List.concat (Array.to_list v.pieces) in
  let rec apart = function
    | [] -> true
    | p :: others ->
      List.for_all (fun o -> Option.is_none (Convex.split o (Convex.sides p))) others && apart others
  in
  apart all

let twice_area points =
  let turn sum (x, y) (x', y') = Rat.add sum (Rat.sub (Rat.mul x y') (Rat.mul x' y)) in
  match points with
  | [] -> Rat.zero
  | first :: _ ->
    let rec around sum = function
      | p :: (q :: _ as rest) -> around (turn sum p q) rest
      | [ last ] -> turn sum last first
      | [] -> sum
    in
    around Rat.zero points

(* The border of what is seen of a face encloses just its pieces, holes counted off. *)
let bordered (s, numbers) =
  let v = see s in
  let sum = List.fold_left Rat.add Rat.zero in
  let face pieces =
    let loops = Outline.loops pieces in
    let inside =
      let crossings (x, y) loop =
        let places = List.map Convex.place loop in
        let side count (ax, ay) (bx, by) =
          let upwards = Rat.compare ay y <= 0 and other = Rat.compare by y <= 0 in
          if Bool.equal upwards other then count
          else
            let at = Rat.add ax (Rat.mul (Rat.sub bx ax) (Rat.div (Rat.sub y ay) (Rat.sub by ay))) in
            if Rat.compare at x > 0 then count + 1 else count
        in
        let last = List.nth places (List.length places - 1) in
        fst (List.fold_left (fun (count, p) q -> (side count p q, q)) (0, last) places)
      in
      fun p -> List.fold_left (fun n loop -> n + crossings p loop) 0 loops mod 2 = 1
    in
    Rat.equal
      (sum (List.map Convex.area2 pieces))
      (sum (List.map (fun loop -> twice_area (List.map Convex.place loop)) loops))
    && List.for_all
      (fun (x, y) ->
         Bool.equal (inside (x, y)) (List.exists (fun c -> Convex.contains c (homogeneous x y)) pieces))
      (somewhere v numbers)
  in
  Array.for_all face v.pieces

(* Close beside an edge, on the side of a face of it, that face is hit just where the edge is drawn. *)
let close = Rat.make Z.one (Z.shift_left Z.one 80)

let edges (s, numbers) =
  let v = see s in
  let beside (e : View.edge) (f : View.face option) turn (x, y) =
    match f with
    | None -> Some false
    | Some f -> (
        let (px, py), (qx, qy) = (Convex.place (fst e.ends), Convex.place (snd e.ends)) in
        let x = Rat.sub x (Rat.mul turn (Rat.sub qy py)) and y = Rat.add y (Rat.mul turn (Rat.sub qx px)) in
        match hit v x y with
        | Face (b, g) -> Some (b = f.body && g = f.face)
        | Nothing -> Some false
        | Unclear -> None)
  in
  let edge (e : View.edge) =
    let drawn = List.map (fun (a, b) -> (Convex.place a, Convex.place b)) (Hidden.segments v.hidden e) in
    let (px, py), (qx, qy) = (Convex.place (fst e.ends), Convex.place (snd e.ends)) in
    let between a b x = Rat.sign (Rat.mul (Rat.sub x a) (Rat.sub x b)) < 0 in
    let at n =
      let t = Rat.make (Z.of_int ((2 * n) + 1)) (Z.of_int 20011) in
      let x = Rat.add px (Rat.mul t (Rat.sub qx px)) and y = Rat.add py (Rat.mul t (Rat.sub qy py)) in
      let here = List.exists (fun ((ax, ay), (bx, by)) -> between ax bx x || between ay by y) drawn in
      (* Of faces of one plane that cover each other a ray does not tell which is seen. *)
      match (beside e e.left close (x, y), beside e e.right (Rat.neg close) (x, y)) with
      | Some left, Some right -> Bool.equal here (left || right)
      | None, _ | _, None -> true
    in
    List.for_all at (List.map fst (List.filteri (fun i _ -> i < 4) numbers))
  in
  Array.for_all edge (Hidden.view v.hidden).edges

(* Of a segment just those points are uncovered that nothing is in front of. *)
let segments (s, numbers) =
  let v = see s in
  let solids = List.map (stands s) s.bodies in
  let height p =
    let n = Ivec.to_vec v.camera.near in
    Vec.dot n (Vec.sub p (Ivec.to_vec v.origin))
  in
  let flat p =
    let x, y = Camera.flat v.camera (Vec.sub p (Ivec.to_vec v.origin)) in
    homogeneous x y
  in
  let one (solid : Naive.solid) (a, b) =
    let p = solid.points.(a) and q = solid.points.(b) in
    Ivec.equal (flat p) (flat q)
    ||
    let parts = Hidden.uncovered v.hidden (flat p, height p) (flat q, height q) in
    let at (n, _) =
      let t = Rat.make (Z.of_int ((2 * n) + 1)) (Z.of_int 20011) in
      let here = Vec.axpy t (Vec.sub q p) p in
      let x, y = Convex.place (flat here) in
      let between ((r, _), (s, _)) = Rat.sign (Rat.mul (Rat.sub x r) (Rat.sub x s)) <= 0 in
      let upright (((_, r), (_, s))) = Rat.sign (Rat.mul (Rat.sub y r) (Rat.sub y s)) <= 0 in
      let on (r, s) =
        let r = Convex.place r and s = Convex.place s in
        between (r, s) && upright (r, s)
      in
      Bool.equal (List.exists on parts) (Hidden.shows v.hidden (flat here) ~depth:(height here))
    in
    List.for_all at (List.filteri (fun i _ -> i < 3) numbers)
  in
  List.for_all (fun solid -> List.for_all (one solid) (Naive.edges solid)) solids

let law ~count name gen holds =
  QCheck2.Test.make ~name ~count ~print:(fun (s, _) -> show s) (Gen.pair gen anywhere) holds

let on kind gen =
  [
    law ~count:60 (kind ^ ": a ray tells what is drawn") gen at_random;
    law ~count:60 (kind ^ ": a ray goes through glass") gen through_glass;
    law ~count:40 (kind ^ ": each piece shows what a ray tells in its middle") gen in_the_middle;
    law ~count:20 (kind ^ ": pieces are disjoint") gen disjoint;
    law ~count:15 (kind ^ ": borders enclose the pieces") gen bordered;
    law ~count:15 (kind ^ ": what is uncovered of a segment has nothing in front") gen segments;
    law ~count:20 (kind ^ ": edges are drawn where their faces are seen") gen edges;
  ]

let with_an_eye =
  let gen = from_an_eye scattered and touching = from_an_eye stacked in
  [
    law ~count:120 "an eye: a ray tells what is drawn" gen at_random;
    law ~count:60 "an eye, solids that touch: a ray tells what is drawn" touching at_random;
    law ~count:60 "an eye: a ray goes through glass" gen through_glass;
    law ~count:60 "an eye: each piece shows what a ray tells in its middle" gen in_the_middle;
    law ~count:30 "an eye: edges are drawn where their faces are seen" gen edges;
  ]

let () =
  Alcotest.run "hidden"
    [
      ("apart", Scc_test_support.Property.cases (on "Solids apart" scattered));
      ("stacked", Scc_test_support.Property.cases (on "Solids that touch" stacked));
      ("an eye", Scc_test_support.Property.cases with_an_eye);
      ("crossing", Scc_test_support.Property.cases (on "Solids that cross" crossing));
    ]
