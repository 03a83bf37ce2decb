(* What a single run can show of a formula. *)

open Scc_exact
open Scc_property
open Property

(* A run shows that something exists, or that not all is so. None shows a probability. *)
let by_one_run () =
  let chance = Chance { side = Least; test = { relation = At_least_so; than = Rat.one } } in
  let under quantifier =
    let f = State (Bool true) in
    [ Next (quantifier, f); Finally (quantifier, Formula.always, f); Globally (quantifier, Formula.always, f);
      Until (quantifier, Formula.always, f, f) ]
  in
  let check what quantifier ~holds ~fails =
    let one f =
      Alcotest.(check (pair bool bool)) what (holds, fails)
        (Formula.by_one_run ~holds:true f, Formula.by_one_run ~holds:false f);
      Alcotest.(check (pair bool bool)) ("not " ^ what) (fails, holds)
        (Formula.by_one_run ~holds:true (Temporal_not f), Formula.by_one_run ~holds:false (Temporal_not f))
    in
    List.iter one (under quantifier)
  in
  check "exists" Exists ~holds:true ~fails:false;
  check "all" All ~holds:false ~fails:true;
  check "chance" chance ~holds:false ~fails:false

let () = Alcotest.run "one run" [ ("quantifiers", [ Alcotest.test_case "what one run shows" `Quick by_one_run ]) ]
