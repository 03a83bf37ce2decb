(* The memories of an exploration: what they hold is what was kept, and what they have forgotten they do not
   know. *)

open Scc_exact
open Scc_space
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
      Contact_memory.rank_of s <= Contact_memory.rank_of t)

let ranks_of_bounds =
  QCheck2.Test.make ~name:"and of times and bounds in floats" ~count:1000 ~print:print_two close_times
    (fun (s, t) ->
       let bound = Scc_geometry.Float_box.down s in
       let m = Contact_memory.create ~most:1 in
       Contact_memory.keep_not_before m 0 (Float.max 0. bound);
       Contact_memory.rank (Contact_memory.find m 0) <= Contact_memory.rank_of t)

(* {1 Sums} *)

exception Given_up

(* Of some numbers there is no value, and some may not be found in the end. *)
let value ~may_fail n =
  if n < 0 then Ok Rat.zero
  else if n = 7 then Error "seven"
  else if n = 8 && may_fail then raise Given_up
  else Ok (ratio ((n * n) - 11) (1 + (n mod 3)))

let integer ~may_fail n = Result.map (fun _ -> Int.max 0 (n + (n * n))) (value ~may_fail n)

let naive zero add value tuple =
  let add sum n = Result.bind sum (fun x -> Result.map (add x) (value ~may_fail:false n)) in
  Array.fold_left add (Ok zero) (Array.sub tuple 0 5)

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
         | found -> found = naive value tuple
         | exception Given_up -> Array.mem 8 tuple)
        &&
        (may_fail := false;
         tuple.(0) mod 2 = 0 || sum tuple = naive value tuple)
      in
      List.for_all is_right tuples)

let sums_of_rationals = sums "sums of tuples in turn" Running_sum.rationals (naive Rat.zero Rat.add) value
let sums_of_integers = sums "the same of integers" Running_sum.integers (naive 0 ( + )) integer

(* {1 Times of contact} *)

type kept = Never | Meeting | Time of Rat.t | Not_before of float

let keep m pair = function
  | Never -> Contact_memory.keep_never m pair
  | Meeting -> Contact_memory.keep_meeting m pair
  | Time t -> Contact_memory.keep_time m pair t
  | Not_before x -> Contact_memory.keep_not_before m pair x

let is_kept m pair kept =
  let code = Contact_memory.find m pair in
  match kept with
  | Never -> code = Contact_memory.never
  | Meeting -> code = Contact_memory.meeting
  | Time t ->
    code <> Contact_memory.never && code <> Contact_memory.meeting
    && Contact_memory.is_exact code
    && Rat.equal (Contact_memory.time m pair) t
    && Contact_memory.rank code = Contact_memory.rank_of t
  | Not_before x ->
    code <> Contact_memory.never && code <> Contact_memory.meeting
    && (not (Contact_memory.is_exact code))
    && Contact_memory.rank code <= Contact_memory.rank_of (Q.of_float x)

let what i =
  match i mod 4 with 0 -> Never | 1 -> Meeting | 2 -> Time (ratio i 7) | _ -> Not_before (float_of_int i /. 3.)

(* So many that it grows several times, and then some that it cannot hold all. *)
let contacts () =
  let m = Contact_memory.create ~most:4096 in
  let pair i = ((i * 7919) lsl 31) lor (i mod 13) in
  let known = ref 0 in
  for i = 1 to 20_000 do
    keep m (pair i) (what i);
    Alcotest.(check bool) "what was kept last" true (is_kept m (pair i) (what i))
  done;
  for i = 1 to 20_000 do
    if Contact_memory.find m (pair i) <> Contact_memory.unknown then begin
      incr known;
      Alcotest.(check bool) "what is known" true (is_kept m (pair i) (what i))
    end
  done;
  Alcotest.(check bool) "much is" true (!known > 2000 && !known <= 4096);
  Alcotest.(check bool) "not what was never kept" true (Contact_memory.find m 5 = Contact_memory.unknown)

let recent () =
  let none = (-1, "") in
  let m = Recent.create ~number:fst ~none ~most:4096 in
  for i = 0 to 9_999 do
    Recent.keep m (i, string_of_int i)
  done;
  for i = 9_999 - 4_095 to 9_999 do
    Alcotest.(check (pair int string)) "the last are there" (i, string_of_int i) (Recent.get m i)
  done;
  Alcotest.(check bool) "others are not" true (fst (Recent.get m 1) <> 1)

let () =
  Alcotest.run "memories"
    [
      ("ranks", Scc_test_support.Property.cases [ ranks; ranks_of_bounds ]);
      ("sums", Scc_test_support.Property.cases [ sums_of_rationals; sums_of_integers ]);
      ("contacts", [ Alcotest.test_case "kept and forgotten" `Quick contacts ]);
      ("recent", [ Alcotest.test_case "kept and forgotten" `Quick recent ]);
    ]
