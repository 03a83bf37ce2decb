(* The heap against a sorted list. *)

open Scc_exact
open Scc_semantics
module Gen = QCheck2.Gen

(* Many times are equal, many differ by less than floats can tell, and some are too great for a float. *)
let time =
  let tiny = Rat.make Z.one (Z.pow (Z.of_int 10) 30) and huge = Rat.make (Z.pow (Z.of_int 10) 400) Z.one in
  let make (whole, fine, scale) =
    let t = Rat.add (Rat.of_int whole) (Rat.mul tiny (Rat.of_int fine)) in
    if scale = 0 then Rat.mul t huge else t
  in
  Gen.map make Gen.(triple (0 -- 3) (0 -- 3) (0 -- 5))

type change = Add of Rat.t | Drop | Keep of int

let change =
  let open Gen in
  frequency [ (6, map (fun t -> Add t) time); (3, pure Drop); (1, map (fun n -> Keep n) (2 -- 5)) ]

let by_time (s, _) (t, _) = Rat.compare s t

let play changes =
  let agenda = Agenda.create fst in
  let step (there, number) = function
    | Add t ->
      Agenda.add agenda (t, number);
      ((t, number) :: there, number + 1)
    | Drop ->
      let first = Agenda.first agenda in
      Agenda.drop_first agenda;
      (match (first, List.sort by_time there) with
       | None, [] -> ([], number)
       | Some (t, item), (least, _) :: _ ->
         if not (Rat.equal t least) then QCheck2.Test.fail_report "not the first one";
         (match List.assoc_opt item (List.map (fun (t, i) -> (i, t)) there) with
          | Some s when Rat.equal s t -> (List.filter (fun (_, i) -> i <> item) there, number)
          | _ -> QCheck2.Test.fail_report "an item at another time")
       | _ -> QCheck2.Test.fail_report "empty or not")
    | Keep n ->
      Agenda.keep agenda (fun (_, i) -> i mod n > 0);
      (List.filter (fun (_, i) -> i mod n > 0) there, number)
  in
  let there, number = List.fold_left step ([], 0) changes in
  let there, _ = List.fold_left step (there, number) (List.map (fun _ -> Drop) there) in
  there = [] && Agenda.size agenda = 0

let sorted = QCheck2.Test.make ~name:"the first comes first" ~count:500 Gen.(list_size (0 -- 120) change) play
let () = Alcotest.run "agenda" [ ("properties", Scc_test_support.Property.cases [ sorted ]) ]
