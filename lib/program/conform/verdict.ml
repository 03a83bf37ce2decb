open Scc_exact
open Scc_calculus
open Scc_semantics

type answer =
  | Conforms of {
      choices : (int * string) list;
      ended : Rat.t;
      deviation : Against.deviation;
      widest : int;
    }
  | Diverges of Divergence.t
  | Undecided of { reason : Trace_search.reason; items : int }

let tolerance (m : Model.t) (trace : Recorded.t) asked =
  let refuse at fmt = Printf.ksprintf (fun s -> Error [ Recorded.malformed at "%s" s ]) fmt in
  match (asked, trace.inexact) with
  | None, Some at -> refuse at "the trace has floats: --tolerance tells how far off they may be (0: not at all)"
  | (None | Some _), _ -> (
      let t = Option.value asked ~default:Rat.zero in
      match (trace.inexact, Model.resolution m) with
      | Some at, Some resolution when Rat.sign t > 0 && Rat.compare t resolution < 0 ->
        refuse at "the tolerance is less than the resolution of the model, %s" (Rat.to_string resolution)
      | _, _ -> Ok t)

(* Draws are seen by their results; who records none of them is not asked for them. Lots are seen by what is
   released. *)
let is_recorded model trace ~observed =
  let tells_draws = Recorded.tells_draws trace in
  fun (label : Transition.label) ->
    match label with
    | Draw _ when not tells_draws -> false
    | Lot _ -> false
    | label -> observed (Transition.label_to_string model label)

let check semantics declared trace ~tolerance ~observed limits =
  let against = Against.make semantics ~tolerance in
  let observed = is_recorded (Against.model against) trace ~observed in
  match Against.names against trace with
  | _ :: _ as faults -> Error (`Invalid faults)
  | [] -> (
      match Trace_search.run against trace declared ~observed limits with
      | Error fault -> Error (`Fault fault)
      | Ok (Met { run; widest }) ->
        Ok
          (Conforms
             { choices = List.rev run.choices; ended = run.time; deviation = run.deviation; widest })
      | Ok (Dead_end dead) -> Ok (Diverges (Divergence.find against trace ~observed dead))
      | Ok (Unknown { reason; items }) -> Ok (Undecided { reason; items }))
