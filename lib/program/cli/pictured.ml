open Scc_base
open Scc_exact
open Scc_semantics
open Scc_motion
open Scc_explain
open Scc_verify
open Scc_loading
open Scc_runs

let by_choices (l : Loaded.t) policy ~until ~interrupted =
  let limits = { Replay.steps = None; time = until; instant = Replay.default_instant } in
  match Chosen_run.follow l policy limits ~interrupted with
  | Ok (course, _) -> Ok course
  | Error (Interrupted _) -> Error []
  | Error (Refused d) -> Error [ d ]
  | Error (Fault f) -> Error [ Replay.diagnostic l.model f ]

let of_witness (l : Loaded.t) (w : Witness.t) =
  let step (s : Witness.step) = (s.transition.label, s.transition.target) in
  let rest = Option.value (Witness.offset w) ~default:Rat.zero in
  Course.make (Witness.semantics l.semantics w) ~initial:w.initial (List.map step w.steps) ~rest

let no_run name =
  [
    Diag.error Code.bad_value Span.command_line "no single run shows the verdict of the check `%s`" name
      ~hint:"without --check it is the run of the first choices that is shown";
  ]

let course console (o : Viewed.options) watch time =
  let* schedule = Viewed.read_schedule console o in
  let* l = Viewed.model console o schedule in
  let* point = Viewed.at_point l in
  let interrupted = Watch.interrupted watch in
  let known course = (l.families, course) in
  match (schedule, o.checks) with
  | Some s, _ -> Result.map known (by_choices point (Scheduled s) ~until:None ~interrupted)
  | None, (All | Unchecked) -> Result.map known (by_choices point First ~until:(Some time) ~interrupted)
  | None, Only name -> (
      let* checks = Viewed.find_check name l.checks in
      let* outcomes, _ = Viewed.report console o l checks watch in
      match List.find_map (fun (v : Verdict.outcome) -> Verdict.shown v.verdict) outcomes with
      | None -> Error (no_run name)
      | Some w -> Ok (known (of_witness point w)))

(* A run may end while time passes: behind its end time goes on until something happens. *)
let at course time =
  let end_ = Course.duration course and semantics = Course.semantics course in
  if Rat.compare time end_ <= 0 then Ok (Course.at course time)
  else
    let last = Course.at course end_ and further = Rat.sub time end_ in
    let over () =
      Error
        [
          Diag.error Code.bad_value Span.command_line "the run is over at time %s, before time %s"
            (Rat.to_string end_) (Rat.to_string time);
        ]
    in
    if Network.quiescent semantics last then Ok (Time.pass semantics further last)
    else
      let passes (t : Transition.t) = Transition.is_time t.label in
      match (Network.successors semantics last, Time.delay semantics last) with
      | Ok next, Some longest when List.exists passes next && Rat.compare further longest < 0 ->
        Ok (Time.pass semantics further last)
      | _ -> over ()

let state console o watch time =
  let* families, course = course console o watch time in
  let* state = at course time in
  Ok (families, Semantics.model (Course.semantics course), state)
