open Scc_state_space
open Scc_explain
open Scc_chance

let formulas = Temporal.formulas

let told what m = Verdict.Undefined (Printf.sprintf "the %s is %s" what (Likelihoods.measured m))
let intervals temporal i = List.map (told "probability") (Formulas.probabilities (formulas temporal) i)

let unclear = Verdict.Undefined "a probability within the formula is not known well enough to be compared"

(* Why exact values were given up, if they were. *)
let given_up (r : Unsettled.t) temporal : Verdict.inexact option =
  let of_reason : Lifting.given_up -> Verdict.inexact = function
    | Interrupted ->
      let stop = Option.value (r.surroundings.stop ()) ~default:Scc_graph_search.Limits.Seconds in
      Cut (Lost.stopped r.lost stop)
    | Too_long -> Too_long
    | Too_much -> Too_much
  in
  Option.map of_reason (Formulas.not_exact (formulas temporal))

let told_inexact why = Verdict.Undefined (Verdict.inexact_to_string why)

(* A probability that is not known well enough is the reason where there is no other. *)
let formula_doubts r temporal i =
  let cut_short = Unsettled.cut_short r temporal in
  match Unsettled.evaluated r (fun () -> (Formulas.doubts (formulas temporal) i, intervals temporal i)) with
  | Error why -> why
  | Ok (doubts, intervals) ->
    let known =
      match Unsettled.doubts r temporal doubts with
      | [] when cut_short = [] -> intervals @ List.map told_inexact (Option.to_list (given_up r temporal))
      | [] -> intervals
      | reasons -> reasons
    in
    (match known @ cut_short with [] -> [ unclear ] | reasons -> reasons)

(* Without the reasons for a claim that nobody has made. *)
let witness (r : Unsettled.t) temporal i =
  Unsettled.explained r temporal i |> Option.map (fun w -> { w with Witness.argument = None })

let reasons_of (r : Unsettled.t) temporal doubts =
  match Unsettled.evaluated r doubts with
  | Ok doubts -> Unsettled.doubts r temporal doubts
  | Error why -> why

(* Why these values are not better known. *)
let reasons (r : Unsettled.t) temporal values doubts =
  if List.for_all (fun (_, m) -> Likelihoods.is_exact m) values then []
  else
    let cut_short = Unsettled.cut_short r temporal in
    reasons_of r temporal doubts @ cut_short

let of_sides temporal sides find =
  Likelihoods.of_sides ~is_chain:(fun () -> Formulas.is_chain (formulas temporal)) sides find

(* The reason why they are intervals, where there is no other. *)
let inexact r temporal values reasons =
  if reasons <> [] || List.for_all (fun (_, m) -> Likelihoods.is_exact m) values then None
  else given_up r temporal

(* All sides at each moment, without those at which nothing changes. *)
let points temporal i sides : (Verdict.point list, string) result =
  let of_side (s, curve) = Option.map (Result.map (fun c -> (s, c))) curve in
  let sides = of_sides temporal sides (Formulas.curve (formulas temporal) i) in
  let* curves = Result.all Fun.id (List.filter_map of_side sides) in
  match curves with
  | (_, first) :: _ ->
    let columns = List.map (fun (s, curve) -> Array.of_list (List.map (fun (_, m) -> (s, m)) curve)) curves in
    let point k (moment, _) : Verdict.point = { moment; answer = List.map (fun column -> column.(k)) columns } in
    let same (a : Verdict.point) (b : Verdict.point) =
      List.for_all2 (fun (_, m) (_, n) -> Likelihoods.equal m n) a.answer b.answer
    in
    let add done_ p = match done_ with last :: _ when same last p -> done_ | _ -> p :: done_ in
    Ok (List.rev (List.fold_left add [] (List.mapi point first)))
  | [] -> Ok []

let probability (r : Unsettled.t) temporal i sides ~curve =
  match Unsettled.evaluated r (fun () -> of_sides temporal sides (Formulas.probability (formulas temporal) i)) with
  | Error why -> Verdict.Undecided why
  | Ok values ->
    let reasons = reasons r temporal values (fun () -> Formulas.possible_doubts (formulas temporal) i) in
    (match Unsettled.evaluated r (fun () -> if curve then points temporal i sides else Ok []) with
     | Error why -> Undecided why
     | Ok (Error why) -> Undecided [ Undefined why ]
     | Ok (Ok curve) ->
       let inexact = inexact r temporal values reasons in
       Measured { values; reasons; inexact; witness = witness r temporal i; curve; starts = [] })

(* As far as what is known above and below tells. *)
let compared r temporal bound m ~reasons : Verdict.t =
  let { Scc_ctl.Eval.least; most } = m in
  match (Answer.holds least bound, Answer.holds most bound) with
  | Some true, Some true -> Holds { bounds = []; witness = None }
  | Some false, Some false -> Violated { witness = None }
  | _ ->
    let reasons = reasons () in
    let not_exact = Option.to_list (inexact r temporal [ ((), m) ] reasons) in
    Undecided ((told "mean" m :: reasons) @ List.map told_inexact not_exact)

let mean (r : Unsettled.t) temporal i sides mean test : Verdict.t =
  let find side = Formulas.mean ?bound:test (formulas temporal) i side mean in
  let undefined = function _, Scc_ctl.Expectation.Unknown { reason; _ } -> reason | _, Known _ -> None in
  let unexplored = function _, Scc_ctl.Expectation.Unknown { unexplored; _ } -> unexplored | _, Known _ -> [] in
  let known = function side, Scc_ctl.Expectation.Known m -> Some (side, m) | _, Unknown _ -> None in
  let of_found found : Verdict.t =
    let texts = List.sort_uniq String.compare (List.filter_map undefined found) in
    let states = List.sort_uniq Int.compare (List.concat_map unexplored found) in
    let unknown =
      List.map (fun text -> Verdict.Undefined text) texts
      @
      if states = [] then []
      else Unsettled.unexplored ~cut_short:(Formulas.is_cut_short (formulas temporal)) r (List.to_seq states)
    in
    let of_values values = reasons r temporal values (fun () -> Formulas.doubts_of_mean (formulas temporal) i) in
    match (unknown, List.filter_map known found, test) with
    | (_ :: _ as reasons), _, _ -> Undecided reasons
    | [], ([ (_, m) ] as values), Some bound -> compared r temporal bound m ~reasons:(fun () -> of_values values)
    | [], values, _ ->
      let reasons = of_values values in
      let inexact = inexact r temporal values reasons in
      Measured { values; reasons; inexact; witness = None; curve = []; starts = [] }
  in
  match Unsettled.evaluated r (fun () -> of_sides temporal sides find) with
  | Error why -> Undecided why
  | Ok found -> of_found found

(* {1 As functions of a parameter} *)

(* Where it was given up, what was found stands beside the reason. *)
let function_of (r : Unsettled.t) range find : ('a, Verdict.reason list) result =
  match Unsettled.evaluated r find with
  | Error why -> Error why
  | Ok (Error { Scc_ctl.Sensitivity.reason; found }) ->
    let why =
      match reason with
      | Unknown why -> Verdict.Undefined why
      | Interrupted ->
        let by stop = Verdict.Unevaluated (Lost.stopped r.lost stop) in
        Option.fold ~none:(Verdict.Undefined "there was too little time") ~some:by (r.surroundings.stop ())
    in
    Error (why :: List.map (fun text -> Verdict.Undefined text) (Depending.found range found))
  | Ok (Ok found) -> Ok found

(* A shape that takes too long is left out. *)
let shaped r (range : Scc_calculus.Ranges.range) pieces : Depending.value =
  let shape () = Dependence.shape ~low:range.low.value ~high:range.high.value pieces in
  { pieces; shape = Result.value (Unsettled.evaluated r shape) ~default:None }

let functions r temporal range sides find =
  let of_side s = Result.map (fun pieces -> (s, shaped r range pieces)) (function_of r range (fun () -> find s)) in
  match sides with
  | first :: others when Formulas.is_chain (formulas temporal) ->
    Result.map (fun (_, p) -> List.map (fun s -> (s, p)) (first :: others)) (of_side first)
  | _ -> Result.all of_side sides

let depends parameter values holds = Verdict.Depends { parameter; values; holds }

let or_undecided doubts = function
  | Ok v -> v
  | Error why -> Verdict.Undecided (why @ doubts ())

let probability_function r temporal s i sides parameter =
  functions r temporal parameter sides (Temporal.probability_function s i)
  |> Result.map (fun values -> depends parameter values None)
  |> or_undecided (fun () -> reasons_of r temporal (fun () -> Formulas.possible_doubts (formulas temporal) i))

let mean_function r temporal s i sides mean (test : Answer.bound option) (parameter : Scc_calculus.Ranges.range) =
  let holds = function
    | (_, { Depending.pieces; _ }) :: _ ->
      let low = parameter.low.value and high = parameter.high.value in
      Option.map (fun bound -> Dependence.where ~low ~high bound pieces) test
    | [] -> None
  in
  functions r temporal parameter sides (fun side -> Temporal.mean_function s i side mean)
  |> Result.map (fun values -> depends parameter values (holds values))
  |> or_undecided (fun () -> reasons_of r temporal (fun () -> Formulas.doubts_of_mean (formulas temporal) i))

let claim_function r temporal s i (formula : Scc_property.Property.temporal) parameter =
  let side =
    match formula with
    | Finally (Chance c, _, _) | Globally (Chance c, _, _) | Until (Chance c, _, _, _) -> [ c.side ]
    | _ -> []
  in
  let found =
    let* set = function_of r parameter (fun () -> Temporal.where s i) in
    let* values = functions r temporal parameter side (Temporal.probability_function s i) in
    Ok (depends parameter values (Some set))
  in
  or_undecided (fun () -> reasons_of r temporal (fun () -> Formulas.possible_doubts (formulas temporal) i)) found
