open Scc_state_space
open Cmdliner

type t = {
  checks : string list;
  witness : string option;
  coverage : bool;
  stats : bool;
  sarif : string option;
  reductions : Reduction.kind list;
  order : State_graph.order;
  compact : bool;
  where : bool;
  smt : string option;
  draw : string option;
  axes : string list;
  slice : (string * Scc_exact.Rat.t) list;
  prove : bool;
  invariant : string option;
  parametric : string option;
  contrast : bool;
  curve : string option;
  plot : string option;
  full : bool;
  jobs : int option;
  store : string option;
}

let checks =
  Chosen_checks.option
    ~doc:"Decides only the check $(docv), as if the model had no others. May be given several times."

let witness =
  Options.maybe Options.named [ "witness" ] ~docv:"DIR"
    "Writes a schedule for each property that has a witness to the folder $(docv), which is created if \
     necessary: $(docv)/$(i,PROPERTY).json. $(b,scc trace --schedule) replays it."

let coverage =
  Options.flag [ "coverage" ]
    "Lists the summands of behaviours that never fired, the behaviours that were never reached, and the channels \
     and rules that were never used. It explores the whole model once more, even if all is decided, and counts \
     during this exploration, within the same bounds; half of the seconds are kept for it. If a bound ends it, \
     the report says how much was explored."

let stats =
  Options.flag [ "stats" ]
    "Prints what the run cost: seconds of each phase, states and transitions a second, memory. The phases are \
     reading, exploring, searching for an invariant, and concluding: making verdicts and runs from the \
     exploration. To standard error, or as $(b,measured) in the JSON document. It varies from run to run."

let sarif =
  Options.maybe Options.named [ "sarif" ] ~docv:"FILE"
    "Writes errors, warnings, and the properties that are violated or undecided to $(docv), as SARIF 2.1.0. \
     Editors and code reviews show them at their places. The steps of a witness are a code flow."

let kind =
  let parse text =
    match Reduction.of_name text with
    | Some kind -> Ok [ kind ]
    | None when String.equal text "all" -> Ok Reduction.all
    | None ->
      let names = String.concat ", " (List.map Reduction.name Reduction.all @ [ "all" ]) in
      Error (`Msg (Printf.sprintf "`%s' is no reduction: expected %s" text names))
  in
  let print ppf kinds = Format.pp_print_string ppf (String.concat "," (List.map Reduction.name kinds)) in
  Arg.conv ~docv:"NAME" (parse, print)

let reductions =
  let names = String.concat ", " (List.map (fun k -> Printf.sprintf "$(b,%s)" (Reduction.name k)) Reduction.all) in
  let doc =
    Printf.sprintf
      "Switches reductions off: %s, or $(b,all); separated by commas. No reduction changes a verdict; see \
       REDUCTIONS."
      names
  in
  let without off = List.filter (fun k -> not (List.exists (Reduction.equal k) (List.concat off))) Reduction.all in
  Term.(
    const (fun off -> without (List.concat off))
    $ Arg.(value & opt_all (list kind) [] & info [ "no-reduce" ] ~docv:"NAME,..." ~doc))

let order =
  let doc =
    "Which runs to show for $(b,possibly) and $(b,always): those with the fewest $(b,steps), or the earliest in \
     model $(b,time). The exploration proceeds in this order."
  in
  let orders = [ ("steps", State_graph.By_steps); ("time", By_time) ] in
  Arg.(value & opt (enum orders) State_graph.By_steps & info [ "shortest" ] ~docv:"ORDER" ~doc)

let compact =
  Options.flag [ "hash-compact" ]
    "Hash compaction: stores a fingerprint of each state instead of the state, which saves about 5 bytes a \
     state. Two states with one fingerprint are taken for one, so that a search that finds nothing proves \
     nothing. Such verdicts hold up to a bound, which names the probability that a state was left out. For \
     $(b,always) and $(b,possibly) without a bound of time, their own or $(b,--time); other properties are \
     checked as usual. Memory for the states of $(b,--states) is reserved at once."

let where =
  Options.flag [ "where" ]
    "For a model with ranges of parameters ($(b,param x in [0, 6])): prints for each property the values for \
     which it holds, exactly, and the probability of these values, if they are independent and uniform in their \
     ranges."

let smt =
  Options.maybe Options.named [ "smt" ] ~docv:"FILE"
    "Like $(b,--where), but writes the sets to $(docv), as a script of SMT-LIB 2.6 that defines for each \
     property where it holds, where it fails, and where that is unknown; and for a number its bounds."

let draw =
  Options.maybe Options.named [ "draw" ] ~docv:"FILE"
    "Like $(b,--where), but draws the sets to $(docv), in SVG: the line of one parameter or the plane of two, \
     divided into regions by the properties that hold there, and by the values of probabilities."

let axes =
  Options.default Arg.(list string) [] [ "axes" ] ~docv:"X,Y"
    "The one or two parameters to $(b,--draw); by default the first ones."

let slice =
  Options.repeated Options.override [ "slice" ] ~docv:"NAME=VALUE"
    "Draws the regions at this value of a parameter that is not an axis. For other such parameters the drawing \
     shows whether a property holds for all of their values, for some, or for none."

let prove =
  Options.flag [ "prove" ]
    "Searches for an invariant: a set of states that no run leaves. It may prove that something never happens \
     where exploring does not end. The search is brief at first, and longer where a bound ended the exploration, \
     all within the bounds. See PROOFS."

let invariant =
  Options.maybe Arg.string [ "invariant" ] ~docv:"FILE"
    "Like $(b,--prove), and writes the invariant on which a verdict rests to $(docv): kinds of states, each with \
     inequalities between its numbers. $(b,-) is standard output."

let jobs =
  Options.maybe Options.processes [ "j"; "jobs" ] ~docv:"J"
    "The number of processes that explore. By default as many as there are cores, once that pays; with 1 only \
     this process. The report is the same for any number, to the byte, unless $(b,--seconds), $(b,--memory) or an \
     interruption ends the work: where that is depends on the time, and on the memory of all processes."

let store =
  let doc =
    "Stores the exploration in the folder $(docv), which is created if necessary, while it proceeds. After an \
     interruption, the same command resumes, and ends with the report of a run that was never interrupted. See \
     STORES."
  in
  Kept.option ~doc

let explored e ~(checks : Scc_property.Property.check list) (budget : Scc_verdicts.Budget.t) =
  let number = function None -> "default" | Some n -> string_of_int n in
  [
    ("what is kept", "explorations of scc check");
    ("--check", match e.checks with
      | [] -> "not given"
      | _ :: _ -> String.concat "," (List.map (fun (c : Scc_property.Property.check) -> c.name) checks));
    ("--no-reduce", String.concat "," (List.filter_map (fun k ->
         if List.exists (Reduction.equal k) e.reductions then None else Some (Reduction.name k)) Reduction.all));
    ("--shortest", match e.order with State_graph.By_steps -> "steps" | By_time -> "time");
    ("--hash-compact", if e.compact then "given" else "not given");
    ("--depth", number budget.depth);
    ("--time", Option.fold ~none:"default" ~some:Scc_exact.Rat.to_string budget.time);
    ("--states", number budget.states);
    ("--bits", number budget.bits);
  ]

let parametric =
  Options.maybe Arg.string [ "parametric" ] ~docv:"NAME"
    "Answers with functions of the parameter $(docv), which the model declares with a range \
     ($(b,param k in (0, 1))) and which stands in weights and chances alone. See PARAMETRIC."

let curve =
  Options.maybe Arg.string [ "curve" ] ~docv:"NAME"
    "Reports the probability that the check $(docv) asks for as a function of time. The check asks $(b,P = ?) of \
     an operator with a bound of time. A table lists all times up to the end of this bound at which the \
     probability changes, and its value from there on. All of them come of one exploration."

let contrast =
  Options.flag [ "contrast" ]
    "Shows with the run of a verdict another one, which does otherwise and parts from it as late as possible. So \
     where a run never comes to what was to come, it shows one that does, and the step that decides. For checks \
     with an operator about all runs or some run, at one start, but for $(b,possibly) and $(b,always) of \
     predicates, which end early."

let plot =
  Options.maybe Options.named [ "curve-plot" ] ~docv:"FILE"
    "Draws the curve of $(b,--curve) as an SVG picture to $(docv)."

let term =
  let make checks witness coverage stats sarif reductions order compact where smt draw axes slice prove invariant
      parametric contrast curve plot full jobs store =
    let prove = prove || Option.is_some invariant in
    {
      checks; witness; coverage; stats; sarif; reductions; order; compact; where; smt; draw; axes; slice; prove;
      invariant; parametric; contrast; curve; plot; full; jobs; store;
    }
  in
  Term.(
    const make $ checks
    $ witness $ coverage $ stats $ sarif $ reductions $ order $ compact $ where $ smt $ draw $ axes
    $ slice $ prove $ invariant $ parametric $ contrast $ curve $ plot
    $ Options.full
      "Prints runs in full: every step and every body, and numbers with all their digits; in JSON all steps of \
       the way to an unexplored state."
    $ jobs $ store)
