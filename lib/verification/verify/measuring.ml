open Scc_state_space
open Scc_explain
open Scc_chance

let told what m = Verdict.Undefined (Printf.sprintf "the %s is %s" what (Likelihoods.measured m))
let intervals temporal i = List.map (told "probability") (Temporal.probabilities temporal i)

(* Without the reasons for a claim that nobody has made. *)
let witness (r : Unsettled.t) temporal i =
  Unsettled.run r (fun () -> Make_witness.of_explanation r.context r.graph temporal (Temporal.explain temporal i))
  |> Option.map (fun w -> { w with Witness.argument = None })

let probability (r : Unsettled.t) temporal i sides =
  let values = List.map (fun side -> (side, Temporal.probability temporal i side)) sides in
  let all_known = List.for_all (fun (_, m) -> Likelihoods.is_exact m) values in
  let reasons = if all_known then [] else Unsettled.doubts r (Temporal.possible_doubts temporal i) in
  Verdict.Measured { values; reasons; witness = witness r temporal i }

(* As far as what is known above and below tells. *)
let compared (r : Unsettled.t) temporal i bound m : Verdict.t =
  let { Scc_ctl.Eval.least; most } = m in
  match (Answer.holds least bound, Answer.holds most bound) with
  | Some true, Some true -> Holds { bounds = []; witness = None }
  | Some false, Some false -> Violated { witness = None }
  | _ -> Undecided (told "mean" m :: Unsettled.doubts r (Temporal.doubts_of_mean temporal i))

let mean (r : Unsettled.t) temporal i sides mean test : Verdict.t =
  let find side = (side, Temporal.mean temporal i side mean) in
  let unknown = function
    | _, Scc_ctl.Expectation.Known _ -> []
    | _, Unknown { reason; unexplored } ->
      List.map (fun text -> Verdict.Undefined text) (Option.to_list reason)
      @ if unexplored = [] then [] else Unsettled.unexplored r (List.to_seq unexplored)
  in
  let known = function side, Scc_ctl.Expectation.Known m -> Some (side, m) | _, Unknown _ -> None in
  let found = List.map find sides in
  let reasons = List.concat_map unknown found in
  let first i reason = not (List.exists (fun r -> r = reason) (List.filteri (fun j _ -> j < i) reasons)) in
  match (List.filteri first reasons, List.filter_map known found, test) with
  | (_ :: _ as reasons), _, _ -> Undecided reasons
  | [], [ (_, m) ], Some bound -> compared r temporal i bound m
  | [], values, _ ->
    let all_known = List.for_all (fun (_, m) -> Likelihoods.is_exact m) values in
    let reasons = if all_known then [] else Unsettled.doubts r (Temporal.doubts_of_mean temporal i) in
    Measured { values; reasons; witness = None }
