(* What must not change, or only as it should, when the same scene is described in another way. *)

open Scc_exact
open Scc_geometry
open Solids

(* All that is asked of an obstacle. *)
type answers = {
  relation : Obstacle.relation;
  cast : Obstacle.cast;
  meeting : (Rat.t option * Rat.t option) option;
  touch : (Ivec.t list * bool) option;  (** separating and approaching, of touching bodies *)
}

let in_order = List.sort Ivec.compare

let ask o r w =
  let relation = Obstacle.relation o r in
  let touch () = (in_order (Obstacle.separating o r), Obstacle.approaching o r w) in
  { relation;
    cast = Obstacle.first_time_of_contact o r w;
    meeting = Obstacle.meeting o r w;
    touch = (match relation with Touching -> Some (touch ()) | Apart | Interpenetrating -> None) }

let same x y =
  x.relation = y.relation
  && equal_cast x.cast y.cast
  && same_interval x.meeting y.meeting
  && Option.equal (fun (n, a) (m, b) -> List.equal Ivec.equal n m && Bool.equal a b) x.touch y.touch

let map_cast f = function Obstacle.At t -> Obstacle.At (f t) | (Never | Inside) as c -> c

let map_times f x =
  let both (a, b) = (Option.map f a, Option.map f b) in
  { x with cast = map_cast f x.cast; meeting = Option.map both x.meeting }

let map_directions f x = { x with touch = Option.map (fun (n, a) -> (in_order (List.map f n), a)) x.touch }
let transform m b = { b with turn = Mat.mul m b.turn }

(* [also] is drawn beside a scene, which is either general or resting. *)
let both name ~count also f =
  let one gen suffix =
    QCheck2.Test.make ~name:(name ^ suffix) ~count ~print:(fun (s, _) -> show s) (Gen.pair gen also) f
  in
  [ one aimed ""; one resting ", on a grid" ]

(* {1 A and B exchanged} *)

let swapped =
  both "B and A see what A and B see" ~count:150 Gen.unit (fun (s, ()) ->
      let back = ask (obstacle s.b s.a) (Vec.neg s.r) (Vec.neg s.w) in
      same (ask (obstacle s.a s.b) s.r s.w) (map_directions Ivec.neg back))

(* {1 Space} *)

(* The image of a scene under a linear map, and the answers for both. *)
let mapped m s =
  let o = obstacle s.a s.b and p = obstacle (transform m s.a) (transform m s.b) in
  (ask o s.r s.w, ask p (Mat.apply m s.r) (Mat.apply m s.w))

let turn_direction m n = Ivec.primitive (fst (Ivec.of_vec (Mat.apply m (Ivec.to_vec n))))

let turned =
  both "the 24 rotations of a cube change nothing" ~count:20 Gen.unit (fun (s, ()) ->
      List.length cube_turns = 24
      && List.for_all
        (fun m ->
           let x, y = mapped m s in
           same (map_directions (turn_direction m) x) y)
        cube_turns)

let turned_anyhow =
  both "nor does any rotation" ~count:60 turn (fun (s, m) ->
      let x, y = mapped m s in
      same (map_directions (turn_direction m) x) y)

let factors =
  let power k = Rat.make (Z.pow (Z.of_int 10) k) Z.one in
  Gen.oneofl
    [ Rat.make Z.one (Z.of_int 3); Rat.of_int 7; Rat.make (Z.of_int 22) (Z.of_int 7); power 30;
      Rat.div Rat.one (power 30); Rat.div (power 400) (Rat.of_int 7); Rat.div Rat.one (power 400) ]

let scaled =
  both "scaling shapes, offsets and velocities changes nothing" ~count:100 factors (fun (s, k) ->
      let x, y = mapped (Mat.scale k Mat.identity) s in
      same x y)

(* Convex sets meet or not whatever the coordinates are; only directions are measured differently. *)
let skewed =
  let v = Vec.of_ints in
  let maps =
    [ Mat.make (v 1 1 0) (v 0 1 0) (v 0 0 1); Mat.make (v 1 0 0) (v 0 50 0) (v 0 0 3);
      Mat.make (v 3 1 2) (v 0 1 (-1)) (v 1 0 2) ]
  in
  both "no linear map changes anything but directions" ~count:60 (Gen.oneofl maps) (fun (s, m) ->
      let x, y = mapped m s in
      let size x = Option.map (fun (n, _) -> List.length n) x.touch in
      let approaching x = Option.map snd x.touch in
      same { x with touch = None } { y with touch = None }
      && Option.equal Int.equal (size x) (size y)
      && Option.equal Bool.equal (approaching x) (approaching y))

(* The same bodies about other reference points: with [d] = [e] for bodies that are not turned, everything is
   translated; an offset far away makes the integers behind long. *)
let translated =
  let far (x, k) = Vec.scale (Rat.of_int k) x in
  let shift = Gen.map far (Gen.pair offset (Gen.oneofl [ 1; 1_000; 1_000_000_007 ])) in
  both "the choice of reference points changes nothing" ~count:100 (Gen.pair shift shift) (fun (s, (d, e)) ->
      let about d b = { b with plain = Naive.move Mat.identity d b.plain } in
      let o = obstacle s.a s.b and p = obstacle (about d s.a) (about e s.b) in
      let r = Vec.sub (Vec.add s.r (Mat.apply s.a.turn d)) (Mat.apply s.b.turn e) in
      same (ask o s.r s.w) (ask p r s.w))

(* {1 Time} *)

let faster =
  both "velocities that are k times as great divide times by k" ~count:100 factors (fun (s, k) ->
      let o = obstacle s.a s.b in
      let slow = ask o s.r s.w and fast = ask o s.r (Vec.scale k s.w) in
      same (map_times (fun t -> Rat.div t k) slow) fast)

let instants =
  let fraction (n, d) = Rat.make (Z.of_int n) (Z.of_int d) in
  Gen.map fraction (Gen.pair Gen.(-12 -- 12) Gen.(1 -- 5))

(* Seen from the time d, everything happens d earlier, and a cast that begins between the first and the last
   time of interior contact begins inside. *)
let shifted =
  both "beginning at another time of the same line" ~count:150 instants (fun (s, d) ->
      let o = obstacle s.a s.b in
      let now = ask o s.r s.w and later = ask o (Vec.axpy d s.w s.r) s.w in
      let less t = Rat.sub t d in
      same_interval (map_times less now).meeting later.meeting
      && match (now.cast, now.meeting) with
      | Never, _ -> Rat.sign d < 0 || equal_cast later.cast Never
      | (Inside | At _), Some (Some first, Some last) ->
        let c = Rat.compare d first in
        if c <= 0 then equal_cast later.cast (At (less first))
        else if Rat.compare d last < 0 then equal_cast later.cast Inside && later.relation = Interpenetrating
        else equal_cast later.cast Never && Bool.equal (later.relation = Touching) (Rat.equal d last)
      | Inside, Some (None, None) -> equal_cast later.cast Inside
      | _ -> false)

let mirror = Option.map (fun (a, b) -> (Option.map Rat.neg b, Option.map Rat.neg a))

(* Backwards, a line meets the obstacle at the opposite times. If the interiors meet, a run that begins 1 before
   the first meeting collides at 1, and so does the run backwards that begins 1 after the last; otherwise neither
   ever collides. *)
let reversed =
  both "time runs backwards as forwards" ~count:150 Gen.unit (fun (s, ()) ->
      let o = obstacle s.a s.b in
      let back = Vec.neg s.w in
      let meeting = Obstacle.meeting o s.r s.w in
      same_interval (mirror meeting) (Obstacle.meeting o s.r back)
      && match meeting with
      | Some (Some first, Some last) ->
        let at t = Vec.axpy t s.w s.r in
        let forth = Obstacle.first_time_of_contact o (at (Rat.sub first Rat.one)) s.w
        and back = Obstacle.first_time_of_contact o (at (Rat.add last Rat.one)) back in
        let middle = Vec.scale (Rat.make Z.one (Z.of_int 2)) (Vec.add (at first) (at last)) in
        let expected =
          match Obstacle.relation o middle with
          | Interpenetrating -> Obstacle.At Rat.one
          | Touching | Apart -> Never
        in
        equal_cast forth expected && equal_cast back expected
        && Obstacle.relation o (at first) = Touching
        && Obstacle.relation o (at last) = Touching
      | Some _ -> Vec.is_zero s.w
      | None -> true)

(* {1 Contacts} *)

let contact_of s =
  let o = obstacle s.a s.b in
  if Obstacle.relation o s.r = Touching then Some (o, s.r) else collision s

let same_pair (p : Contact.pair) (q : Contact.pair) =
  Feature.equal p.first q.first && Feature.equal p.second q.second && Int.equal p.dimension q.dimension

(* The features in contact stay, and the region moves along. *)
let contacts_move =
  let maps = Gen.oneof [ Gen.oneofl cube_turns; turn; Gen.map (fun k -> Mat.scale k Mat.identity) factors ] in
  both "contacts turn and grow with the bodies" ~count:60 maps (fun (s, m) ->
      match contact_of s with
      | None -> true
      | Some (o, r) ->
        let p = obstacle (transform m s.a) (transform m s.b) and r' = Mat.apply m r in
        let sorted = List.sort Vec.compare in
        let region = List.map (Mat.apply m) (Contact.region o r) in
        same_pair (Contact.highest o r) (Contact.highest p r')
        && List.equal same_pair (Contact.touching o r) (Contact.touching p r')
        && List.equal Vec.equal (sorted region) (sorted (Contact.region p r')))

let () =
  let group name tests = (name, Scc_test_support.Property.cases (List.concat tests)) in
  Alcotest.run "symmetries"
    [ group "bodies" [ swapped ]; group "space" [ turned; turned_anyhow; scaled; skewed; translated ];
      group "time" [ faster; shifted; reversed ]; group "contacts" [ contacts_move ] ]
