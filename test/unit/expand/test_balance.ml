(* What is left to the process that has the graph, as a clock goes that stands still but for what work is said to
   take. *)

open Scc_parallel

type world = { balance : Balance.t; clock : float ref }

let world () =
  let clock = ref 0. in
  { balance = Balance.create ~now:(fun () -> !clock); clock }

let work w seconds () = w.clock := !(w.clock) +. seconds

(* Of 64 states with numbers one after the other. *)
let here w = List.length (List.filter (Balance.is_here w.balance) (List.init 64 Fun.id))

let times n f = for i = 0 to n - 1 do f i done

(* Others answer, and have waited for so long; one of 64 states is found here. *)
let answers ?(count = 100) w ~find ~tell ~waited =
  times count (fun _ ->
      Balance.telling w.balance (work w (tell *. 32.));
      times 64 (fun i -> Balance.hearing w.balance i (work w (tell /. 2.)));
      Balance.finding w.balance (work w find);
      Balance.answered w.balance ~states:64 ~waited ~worked:(64. *. find))

let check = Alcotest.(check int)

let who_waits () =
  let w = world () in
  check "all are told at first" 0 (here w);
  times 10 (fun _ -> Balance.waited w.balance);
  check "a state for each wait" 10 (here w);
  times 100 (fun _ -> Balance.waited w.balance);
  check "but for one" 63 (here w);
  answers w ~find:1e-4 ~tell:1e-6 ~waited:0.;
  check "nobody waits" 63 (here w);
  answers w ~find:1e-4 ~tell:1e-6 ~waited:1.;
  check "others wait" 0 (here w)

let what_costs_more () =
  let w = world () in
  answers w ~find:1e-6 ~tell:1e-6 ~waited:1.;
  answers w ~find:1e-6 ~tell:1e-6 ~waited:1.;
  check "to tell takes as long as to find, at least" 64 (here w);
  times 40_000 (fun _ -> Balance.finding w.balance (work w 1e-6));
  check "it is tried again" 63 (here w);
  answers w ~find:1e-6 ~tell:1e-6 ~waited:1.;
  check "with the same result" 64 (here w);
  times 40_000 (fun _ -> Balance.finding w.balance (work w 1e-3));
  answers w ~find:1e-3 ~tell:1e-6 ~waited:1.;
  check "states that take longer" 0 (here w)

(* An answer says what it costs to tell of 64 states. *)
let how_soon () =
  let after count ~tell =
    let w = world () in
    answers w ~count ~find:1e-6 ~tell ~waited:0.;
    here w
  in
  check "to tell takes six times as long" 64 (after 20 ~tell:2e-6);
  check "that may change, as long as little has been told" 9 (after 10 ~tell:2e-6);
  check "one and a half times" 19 (after 20 ~tell:0.5e-6);
  check "less" 0 (after 20 ~tell:0.1e-6)

let how_many () =
  let w = world () in
  let told seconds =
    let b = w.balance in
    Balance.answered b ~states:10 ~waited:0. ~worked:(10. *. seconds);
    (Balance.batch b, Balance.least b, Balance.least_ahead b, Balance.between_looks b)
  in
  let sizes = Alcotest.(pair (pair int int) (pair int int)) in
  let pairs (a, b, c, d) = ((a, b), (c, d)) in
  let check what expected seconds = Alcotest.check sizes what (pairs expected) (pairs (told seconds)) in
  check "10 us" (200, 5, 64, 6) 10e-6;
  check "a second" (1, 1, 1, 1) 1.;
  check "nothing" (2048, 500, 64, 64) 0.

let pays () =
  let w = world () in
  times 1000 (fun _ -> Balance.finding w.balance (work w 1e-6));
  Alcotest.(check bool) "a microsecond" false (Balance.pays w.balance);
  times 4000 (fun _ -> Balance.finding w.balance (work w 1e-5));
  Alcotest.(check bool) "ten" true (Balance.pays w.balance)

let () =
  Alcotest.run "balance"
    [
      ( "cases",
        [
          Alcotest.test_case "who waits" `Quick who_waits;
          Alcotest.test_case "what costs more" `Quick what_costs_more;
          Alcotest.test_case "how soon" `Quick how_soon;
          Alcotest.test_case "how many states" `Quick how_many;
          Alcotest.test_case "whether it pays" `Quick pays;
        ] );
    ]
