(* The site lemma: whether channels find a pair of features is a matter of points, not of how surfaces are
   divided. *)

open Scc_exact
open Scc_geometry
open Solids

(* Some features of a solid, by numbers. *)
let some_features (p : Polyhedron.t) picks =
  let all = Array.of_list (Polyhedron.closure p (List.init (Array.length p.faces) (fun f -> Feature.Face f))) in
  List.sort_uniq Feature.compare (List.map (fun k -> all.(k mod Array.length all)) picks)

let corners (s : Solid.t) offset feature =
  List.map (fun v -> Vec.add offset (Solid.vertex s v)) (Solid.corners s feature)

(* Features are closed: hulls of their corners. *)
let meet one two =
  List.exists (fun a -> List.exists (Scc_rigid.Near_contact.within ~resolution:Rat.zero a) two) one

let lemma (s, (picks, others)) =
  let touching =
    let o = obstacle s.a s.b in
    if Obstacle.relation o s.r = Touching then Some (o, s.r) else collision s
  in
  match touching with
  | None -> true
  | Some (o, r) ->
    let a = solid ~id:0 s.a and b = solid ~id:1 s.b in
    let one = some_features a.polyhedron picks and two = some_features b.polyhedron others in
    let in_closure p listed feature = List.exists (Feature.equal feature) (Polyhedron.closure p listed) in
    let candidate (pair : Contact.pair) =
      in_closure a.polyhedron one pair.first && in_closure b.polyhedron two pair.second
    in
    Bool.equal
      (List.exists candidate (Contact.touching o r))
      (meet (List.map (corners a Vec.zero) one) (List.map (corners b r) two))

let picks = Gen.(list_size (1 -- 3) (0 -- 1000))

let holds name gen =
  QCheck2.Test.make ~name ~count:300
    ~print:(fun (s, _) -> show s)
    (Gen.pair gen (Gen.pair picks picks))
    lemma

let () =
  Alcotest.run "sites"
    [
      ( "Sites",
        Scc_test_support.Property.cases
          [
            holds "Sites: two channels find a pair of features iff their surfaces meet" aimed;
            holds "Sites: where bodies lie on each other" resting;
          ] );
    ]
