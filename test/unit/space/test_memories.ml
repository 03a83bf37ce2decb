(* The memories of an exploration: what they hold is what was kept, and what they have forgotten they do not
   know. *)

open Scc_exact
open Scc_state_space
module Gen = QCheck2.Gen

let ratio n d = Rat.make (Z.of_int n) (Z.of_int d)
let time = Gen.map2 ratio Gen.(0 -- 1000) Gen.(1 -- 50)

(* Rationals next to each other, that floats can hardly tell apart, and great ones. *)
let close_times =
  let open Gen in
  let* t = time and* k = -70 -- 70 and* great = bool in
  let little = if k < 0 then Q.make Z.one (Z.shift_left Z.one (-k)) else Q.of_bigint (Z.shift_left Z.one k) in
  let t = if great then Rat.mul t (Q.of_bigint (Z.shift_left Z.one 1100)) else t in
  return (t, Rat.add t little)

let print_two (s, t) = Rat.to_string s ^ ", " ^ Rat.to_string t

let ranks =
  QCheck2.Test.make ~name:"ranks keep the order of times" ~count:1000 ~print:print_two close_times (fun (s, t) ->
      Contact_cache.rank_of s <= Contact_cache.rank_of t)

let ranks_of_bounds =
  QCheck2.Test.make ~name:"and of times and bounds in floats" ~count:1000 ~print:print_two close_times
    (fun (s, t) ->
       let bound = Scc_geometry.Float_box.down s in
       let m = Contact_cache.create ~most:1 in
       Contact_cache.keep_not_before m 0 (Float.max 0. bound);
       Contact_cache.rank (Contact_cache.find m 0) <= Contact_cache.rank_of t)

(* {1 Sums} *)

exception Given_up

(* Of some numbers there is no value, and some may not be found in the end. *)
let value ~may_fail n =
  if n < 0 then Ok Rat.zero
  else if n = 7 then Error "seven"
  else if n = 8 && may_fail then raise Given_up
  else Ok (ratio ((n * n) - 11) (1 + (n mod 3)))

let integer ~may_fail n =
  if n < 0 then 0 else if n = 8 && may_fail then raise Given_up else (n * n) - (11 * n) + 3

let naive_of_rationals tuple =
  let add sum n = Result.bind sum (fun x -> Result.map (Rat.add x) (value ~may_fail:false n)) in
  Array.fold_left add (Ok Rat.zero) (Array.sub tuple 0 5)

let naive_of_integers tuple =
  Array.fold_left (fun sum n -> sum + integer ~may_fail:false n) 0 (Array.sub tuple 0 5)

let tuples = Gen.(list_size (1 -- 30) (array_size (return 6) (-1 -- 8)))
let print_tuples = QCheck2.Print.(list (array int))

(* Sums of tuples in turn, some of which are given up, are those of each for itself. *)
let sums name running naive value =
  QCheck2.Test.make ~name ~count:2000 ~print:print_tuples tuples (fun tuples ->
      let may_fail = ref false in
      let sum = running ~width:5 (fun n -> value ~may_fail:!may_fail n) in
      let is_right tuple =
        may_fail := true;
        (match sum tuple with
         | found -> found = naive tuple
         | exception Given_up -> Array.mem 8 tuple)
        &&
        (may_fail := false;
         tuple.(0) mod 2 = 0 || sum tuple = naive tuple)
      in
      List.for_all is_right tuples)

let sums_of_rationals = sums "sums of tuples in turn" Running_sum.rationals naive_of_rationals value
let sums_of_integers = sums "the same of integers" Running_sum.integers naive_of_integers integer

(* {1 Times of contact} *)

type kept = Never | Meeting | Time of Rat.t | Not_before of float

let keep m pair = function
  | Never -> Contact_cache.keep_never m pair
  | Meeting -> Contact_cache.keep_meeting m pair
  | Time t -> Contact_cache.keep_time m pair t
  | Not_before x -> Contact_cache.keep_not_before m pair x

let is_kept m pair kept =
  let code = Contact_cache.find m pair in
  match kept with
  | Never -> code = Contact_cache.never
  | Meeting -> code = Contact_cache.meeting
  | Time t ->
    code <> Contact_cache.never && code <> Contact_cache.meeting
    && Contact_cache.is_exact code
    && Rat.equal (Contact_cache.time m pair) t
    && Contact_cache.rank code = Contact_cache.rank_of t
  | Not_before x ->
    code <> Contact_cache.never && code <> Contact_cache.meeting
    && (not (Contact_cache.is_exact code))
    && Contact_cache.rank code <= Contact_cache.rank_of (Q.of_float x)

let what i =
  match i mod 4 with 0 -> Never | 1 -> Meeting | 2 -> Time (ratio i 7) | _ -> Not_before (float_of_int i /. 3.)

(* So many that it grows several times, and then some that it cannot hold all. *)
let contacts () =
  let m = Contact_cache.create ~most:4096 in
  let pair i = ((i * 7919) lsl 31) lor (i mod 13) in
  let known = ref 0 in
  for i = 1 to 20_000 do
    keep m (pair i) (what i);
    Alcotest.(check bool) "what was kept last" true (is_kept m (pair i) (what i))
  done;
  for i = 1 to 20_000 do
    if Contact_cache.find m (pair i) <> Contact_cache.unknown then begin
      incr known;
      Alcotest.(check bool) "what is known" true (is_kept m (pair i) (what i))
    end
  done;
  Alcotest.(check bool) "much is" true (!known > 2000 && !known <= 4096);
  Alcotest.(check bool) "not what was never kept" true (Contact_cache.find m 5 = Contact_cache.unknown)

let recent () =
  let none = (-1, "") in
  let m = Scc_data.Recent.create ~number:fst ~none ~most:4096 in
  for i = 0 to 9_999 do
    Scc_data.Recent.keep m (i, string_of_int i)
  done;
  for i = 9_999 - 4_095 to 9_999 do
    Alcotest.(check (pair int string)) "the last are there" (i, string_of_int i) (Scc_data.Recent.get m i)
  done;
  Alcotest.(check bool) "others are not" true (fst (Scc_data.Recent.get m 1) <> 1)

(* {1 Who stands in some slots} *)

(* The catalogue of a model, and what each slot holds in some of its states. *)
let slots_of name =
  let open Scc_graph_search in
  let e = Scc_test_models.Load.(exactly (file ("../../../specs/models/" ^ name))) in
  let semantics = Scc_engine.Standard.of_model e.model in
  let start = Result.get_ok (Scc_semantics.Network.initial semantics e.declared) in
  let context = Network_lts.make semantics start in
  let limits = { Limits.unlimited with states = Some 300 } in
  let g = State_graph.run limits Limits.quiet context in
  let local = Local.create ~events:[] ~time_seen:Scc_property.Time_seen.Always ~memory:1024 semantics in
  let again i =
    State_graph.tuple g i
    |> Catalogue.decode (Network_lts.catalogue context)
    |> Catalogue.encode (Local.catalogue local)
  in
  let tuples = List.init (State_graph.size g) again in
  let held slot = List.sort_uniq Int.compare (List.map (fun tuple -> tuple.(slot)) tuples) in
  (local, Array.init (Array.length (Catalogue.model (Local.catalogue local)).leaves) held)

let sections name =
  let local, held = slots_of name in
  let n = Array.length held in
  (* Few for each slot, so that they come again, and many tuples, so that they take each other's places. *)
  let tuple = Gen.(flatten_a (Array.map (fun numbers -> oneofl (List.filteri (fun i _ -> i < 4) numbers)) held)) in
  let case = Gen.(pair (0 -- n) (pair (list_size (return 300) tuple) (oneofl [ Rat.one; ratio 1 3 ]))) in
  QCheck2.Test.make ~count:30 ~name:("who stands in slots of " ^ name) case (fun (middle, (tuples, d)) ->
      let left = Section.memory local ~first:0 ~beyond:middle
      and right = Section.memory local ~first:middle ~beyond:n in
      let alone tuple first beyond =
        List.init (beyond - first) (fun k -> tuple.(first + k))
        |> List.filter (fun number -> number <> Catalogue.nobody)
        |> List.map (Local.alone local)
      in
      let number (a : Local.alone) = a.body.number in
      let waits = List.filter_map (fun (a : Local.alone) -> a.nature.wait) in
      let least = function [] -> None | w :: rest -> Some (List.fold_left Rat.min w rest) in
      let velocity (a : Local.alone) = a.body.velocity in
      let velocities those = List.sort_uniq Int.compare (List.map velocity those) in
      let last_first moves those = List.rev (List.concat_map moves those) in
      let later those =
        let change (a : Local.alone) =
          let number' = Local.after local d a in
          if number' = number a then [] else [ Catalogue.first_leaf a.body.process; number' ]
        in
        Array.of_list (List.concat_map change those)
      in
      let is_right s those =
        List.map number (Array.to_list (Section.present s)) = List.map number those
        && List.equal ( == ) (Section.urgent s) (last_first (fun (a : Local.alone) -> a.urgent) those)
        && List.equal ( == ) (Section.weak s) (last_first (fun (a : Local.alone) -> a.weak) those)
        && Option.equal Rat.equal (Section.wait s) (least (waits those))
        && Bool.equal (Section.rest s) (List.for_all (fun (a : Local.alone) -> a.rests) those)
        && Section.after local d s = later those
      in
      let looked_at tuple =
        let one = Section.look left tuple and other = Section.look right tuple in
        let these = alone tuple 0 middle and those = alone tuple middle n in
        is_right one these && is_right other those
        && Bool.equal (Section.in_relative_motion one other) (List.length (velocities (these @ those)) > 1)
        && is_right (Section.of_present (Array.of_list (these @ those))) (these @ those)
      in
      List.for_all looked_at tuples)

(* What comes again is there from the third time on, as the same. *)
let sections_remembered () =
  let local, held = slots_of "hexokinase.sc" in
  let n = Array.length held in
  let m = Section.memory local ~first:0 ~beyond:n in
  let some = Array.map List.hd held and other = Array.map (fun numbers -> List.hd (List.rev numbers)) held in
  let first = Section.look m some in
  let second = Section.look m some in
  ignore (Section.look m other);
  Alcotest.(check bool) "not the first time" false (first == second);
  Alcotest.(check bool) "then it is" true (Section.look m some == second);
  Alcotest.(check bool) "others are others" false (Section.look m other == second)

let () =
  Alcotest.run "memories"
    [
      ("ranks", Scc_test_support.Property.cases [ ranks; ranks_of_bounds ]);
      ("sums", Scc_test_support.Property.cases [ sums_of_rationals; sums_of_integers ]);
      ("contacts", [ Alcotest.test_case "kept and forgotten" `Quick contacts ]);
      ("sections", Alcotest.test_case "remembered" `Quick sections_remembered
                   :: Scc_test_support.Property.cases
                     (List.map sections [ "hexokinase.sc"; "gas.sc"; "dimers.sc" ]));
      ("recent", [ Alcotest.test_case "kept and forgotten" `Quick recent ]);
    ]
