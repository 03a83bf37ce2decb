(* How many states processes take at a time, as a clock goes that stands still but for what work is said to take. *)

open Scc_parallel

type world = { balance : Balance.t; clock : float ref }

let world () =
  let clock = ref 0. in
  { balance = Balance.create ~now:(fun () -> !clock); clock }

let work w seconds () = w.clock := !(w.clock) +. seconds
let times n f = for i = 0 to n - 1 do f i done

let how_many () =
  let w = world () in
  let after seconds ~waiting ~jobs =
    Balance.answered w.balance ~states:10 ~worked:(10. *. seconds);
    Balance.request w.balance ~waiting ~jobs
  in
  let check what expected found = Alcotest.(check int) what expected found in
  check "10 us" 50 (after 10e-6 ~waiting:100_000 ~jobs:2);
  check "a second" 1 (after 1. ~waiting:100_000 ~jobs:2);
  check "nothing" 512 (after 0. ~waiting:100_000 ~jobs:2);
  check "few wait" 25 (after 1e-6 ~waiting:100 ~jobs:2);
  check "for many" 3 (after 1e-6 ~waiting:100 ~jobs:16);
  check "hardly any" 1 (after 1e-6 ~waiting:1 ~jobs:16)

let pays () =
  let w = world () in
  times 1000 (fun _ -> Balance.finding w.balance (work w 1e-7));
  Alcotest.(check bool) "a tenth of a microsecond" false (Balance.pays w.balance);
  times 4000 (fun _ -> Balance.finding w.balance (work w 1e-6));
  Alcotest.(check bool) "a microsecond" true (Balance.pays w.balance)

let () =
  Alcotest.run "balance"
    [
      ( "cases",
        [
          Alcotest.test_case "how many states" `Quick how_many;
          Alcotest.test_case "whether it pays" `Quick pays;
        ] );
    ]
