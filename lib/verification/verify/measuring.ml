open Scc_state_space
open Scc_explain
open Scc_chance

let told what m = Verdict.Undefined (Printf.sprintf "the %s is %s" what (Likelihoods.measured m))
let intervals temporal i = List.map (told "probability") (Temporal.probabilities temporal i)

(* Without the reasons for a claim that nobody has made. *)
let witness (r : Unsettled.t) temporal i =
  Unsettled.run r (fun () -> Make_witness.of_explanation r.context r.graph temporal (Temporal.explain temporal i))
  |> Option.map (fun w -> { w with Witness.argument = None })

(* Why these values are not better known. *)
let reasons (r : Unsettled.t) values doubts =
  if List.for_all (fun (_, m) -> Likelihoods.is_exact m) values then []
  else
    match Unsettled.evaluated r doubts with
    | Ok doubts -> Unsettled.doubts r doubts
    | Error why -> why

(* Where nothing is left to choose, what is found for one side is so for the other. *)
let of_sides temporal sides find =
  match sides with
  | first :: (_ :: _ as others) when Temporal.is_chain temporal ->
    let found = find first in
    (first, found) :: List.map (fun s -> (s, found)) others
  | _ -> List.map (fun s -> (s, find s)) sides

(* All sides at each moment, without those at which nothing changes. *)
let points temporal i sides : Verdict.point list =
  let of_side (s, curve) = Option.map (fun c -> (s, c)) curve in
  match List.filter_map of_side (of_sides temporal sides (Temporal.curve temporal i)) with
  | (_, first) :: _ as curves ->
    let columns = List.map (fun (s, curve) -> Array.of_list (List.map (fun (_, m) -> (s, m)) curve)) curves in
    let point k (moment, _) : Verdict.point = { moment; answer = List.map (fun column -> column.(k)) columns } in
    let same (a : Verdict.point) (b : Verdict.point) =
      List.for_all2 (fun (_, m) (_, n) -> Likelihoods.equal m n) a.answer b.answer
    in
    let add done_ p = match done_ with last :: _ when same last p -> done_ | _ -> p :: done_ in
    List.rev (List.fold_left add [] (List.mapi point first))
  | [] -> []

let probability (r : Unsettled.t) temporal i sides ~curve =
  match Unsettled.evaluated r (fun () -> of_sides temporal sides (Temporal.probability temporal i)) with
  | Error why -> Verdict.Undecided why
  | Ok values ->
    let reasons = reasons r values (fun () -> Temporal.possible_doubts temporal i) in
    (match Unsettled.evaluated r (fun () -> if curve then points temporal i sides else []) with
     | Error why -> Undecided why
     | Ok curve -> Measured { values; reasons; witness = witness r temporal i; curve; starts = [] })

(* As far as what is known above and below tells. *)
let compared bound m ~reasons : Verdict.t =
  let { Scc_ctl.Eval.least; most } = m in
  match (Answer.holds least bound, Answer.holds most bound) with
  | Some true, Some true -> Holds { bounds = []; witness = None }
  | Some false, Some false -> Violated { witness = None }
  | _ -> Undecided (told "mean" m :: reasons ())

let mean (r : Unsettled.t) temporal i sides mean test : Verdict.t =
  let find side = Temporal.mean ?bound:test temporal i side mean in
  let undefined = function _, Scc_ctl.Expectation.Unknown { reason; _ } -> reason | _, Known _ -> None in
  let unexplored = function _, Scc_ctl.Expectation.Unknown { unexplored; _ } -> unexplored | _, Known _ -> [] in
  let known = function side, Scc_ctl.Expectation.Known m -> Some (side, m) | _, Unknown _ -> None in
  let of_found found : Verdict.t =
    let texts = List.sort_uniq String.compare (List.filter_map undefined found) in
    let states = List.sort_uniq Int.compare (List.concat_map unexplored found) in
    let unknown =
      List.map (fun text -> Verdict.Undefined text) texts
      @ if states = [] then [] else Unsettled.unexplored r (List.to_seq states)
    in
    let of_values values = reasons r values (fun () -> Temporal.doubts_of_mean temporal i) in
    match (unknown, List.filter_map known found, test) with
    | (_ :: _ as reasons), _, _ -> Undecided reasons
    | [], ([ (_, m) ] as values), Some bound -> compared bound m ~reasons:(fun () -> of_values values)
    | [], values, _ -> Measured { values; reasons = of_values values; witness = None; curve = []; starts = [] }
  in
  match Unsettled.evaluated r (fun () -> of_sides temporal sides find) with
  | Error why -> Undecided why
  | Ok found -> of_found found
