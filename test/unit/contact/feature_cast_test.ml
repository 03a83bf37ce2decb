(* When features meet that slant in any way, against the hull of their differences: p meets q + t w iff t w is a
   difference of a point of each, and the hull of all differences of corners is cut out by the planes through three
   of them; or, if they lie in a plane or on a line, by lines and points in it. *)

open Scc_exact
open Scc_geometry
module Gen = QCheck2.Gen

(* {1 By planes} *)

let pairs list = List.concat_map (fun a -> List.map (fun b -> (a, b)) list) list

(* Normals of the planes that may bound the hull of points, or hold it. *)
let normals points =
  let edges = List.map (fun (a, b) -> Vec.sub b a) (pairs points) |> List.filter (fun v -> not (Vec.is_zero v)) in
  let edges = List.sort_uniq Vec.compare edges in
  let across = List.map (fun (u, v) -> Vec.cross u v) (pairs edges) in
  let across = List.sort_uniq Vec.compare (List.filter (fun v -> not (Vec.is_zero v)) across) in
  let axes = [ Vec.of_ints 1 0 0; Vec.of_ints 0 1 0; Vec.of_ints 0 0 1 ] in
  match (edges, across) with
  | [], _ -> axes
  | along :: _, [] ->
    (* A line: where it begins and ends, and the planes through it. *)
    along :: List.map (Vec.cross along) axes
  | _, flat :: others when List.for_all (fun n -> Vec.is_zero (Vec.cross flat n)) others ->
    flat :: List.map (Vec.cross flat) edges
  | _, _ -> across

let highest n points = List.fold_left (fun h p -> Rat.max h (Vec.dot n p)) (Vec.dot n (List.hd points)) points

(* The times t >= 0 at which t w is in the hull: from the first to the last, or for ever. *)
let clipped points w =
  let clip times n =
    match times with
    | None -> None
    | Some (first, last) -> (
        let speed = Vec.dot n w and room = highest n points in
        match Rat.sign speed with
        | 0 -> if Rat.sign room < 0 then None else times
        | s ->
          let t = Rat.div room speed in
          if s > 0 then Some (first, Some (match last with None -> t | Some l -> Rat.min l t))
          else Some (Rat.max first t, last))
  in
  let both = List.concat_map (fun n -> [ n; Vec.neg n ]) (normals points) in
  match List.fold_left clip (Some (Rat.zero, None)) both with
  | Some (first, Some last) when Rat.compare first last > 0 -> None
  | Some (first, _) -> Some first
  | None -> None

let by_planes p q w = clipped (List.concat_map (fun a -> List.map (Vec.sub a) q) p) w

(* {1 At random} *)

let small = Gen.int_range (-3) 3

let rational = Gen.(map2 (fun n d -> Rat.make (Z.of_int n) (Z.of_int d)) (int_range (-6) 6) (int_range 1 3))
let point = Gen.map3 Vec.of_ints small small small

(* A vertex, an edge, a triangle or a parallelogram, in any plane. *)
let feature =
  let open Gen in
  let* a = point and* u = point and* v = point in
  oneofl
    [ [ a ]; [ a; Vec.add a u ]; [ a; Vec.add a u; Vec.add a v ];
      [ a; Vec.add a u; Vec.add (Vec.add a u) v; Vec.add a v ] ]

(* At random most miss; so the second is often put where some point of it comes to some point of the first. *)
let case =
  let open Gen in
  let* p = feature and* q = feature and* w = point in
  let* aim = bool in
  if not aim then return (p, q, w)
  else
    let* t = map Rat.abs rational and* i = int_bound 3 and* j = int_bound 3 in
    let at list k = List.nth list (k mod List.length list) in
    let* weight = oneofl [ Rat.zero; Rat.one; Rat.make Z.one (Z.of_int 2); Rat.make Z.one (Z.of_int 3) ] in
    let inner list k = Vec.axpy weight (Vec.sub (at list (k + 1)) (at list k)) (at list k) in
    let move = Vec.sub (Vec.axpy (Rat.neg t) w (inner p i)) (inner q j) in
    return (p, List.map (Vec.add move) q, w)

let show = function None -> "never" | Some t -> Rat.to_string t

let print (p, q, w) =
  let list l = String.concat " " (List.map Vec.to_string l) in
  Printf.sprintf "%s\n%s by %s" (list p) (list q) (Vec.to_string w)

let random =
  QCheck2.Test.make ~count:1000 ~name:"I-33: when slanted features meet, by the planes of the hull" ~print case
    (fun (p, q, w) ->
       let expected = show (by_planes p q w) and found = show (Feature_cast.first_meeting p q w) in
       if String.equal expected found then true
       else QCheck2.Test.fail_reportf "%s by planes, %s by the program" expected found)

let by_hand () =
  let v = Vec.of_ints in
  let check what expected p q w =
    Alcotest.(check string) what expected (show (Feature_cast.first_meeting p q w));
    Alcotest.(check string) (what ^ ", by planes") expected (show (by_planes p q w))
  in
  let slant = [ v 3 0 0; v 0 3 0; v 0 0 3 ] in
  check "a vertex to a slanted face" "1" slant [ v 2 2 2 ] (v (-1) (-1) (-1));
  check "past it" "never" slant [ v 5 5 0 ] (v 0 0 (-1));
  check "to its edge" "7/2" slant [ v 5 5 0 ] (v (-1) (-1) 0);
  check "within its plane, to a corner" "2" slant [ v 5 (-2) 0 ] (v (-1) 1 0);
  check "within its plane, past it" "never" slant [ v 5 (-1) (-1) ] (v 0 1 (-1));
  check "two edges that cross" "2" [ v 0 0 0; v 2 2 0 ] [ v 2 0 2; v 0 2 2 ] (v 0 0 (-1));
  check "two faces in one plane" "1/2" slant [ v 4 (-1) 0; v 5 (-1) (-1); v 5 (-2) 0 ] (v (-2) 2 0);
  check "there already, and at rest" "0" slant [ v 1 1 1 ] (v 0 0 0);
  check "never, at rest" "never" slant [ v 1 1 2 ] (v 0 0 0);
  check "going apart" "never" slant [ v 2 2 2 ] (v 1 1 1)

let suite =
  ("features that meet",
   [
     ("random", Scc_test_support.Property.cases [ random ]);
     ("cases", [ Alcotest.test_case "by hand" `Quick by_hand ]);
   ])
