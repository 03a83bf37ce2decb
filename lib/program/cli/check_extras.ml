open Scc_state_space
open Cmdliner

type t = {
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
  full : bool;
  jobs : int option;
  store : string option;
}

let witness =
  let doc =
    "Writes a schedule for each property that has a witness to the folder $(docv), which is made if need \
     be: $(docv)/$(i,PROPERTY).json. $(b,scc trace --schedule) replays it."
  in
  Arg.(value & opt (some string) None & info [ "witness" ] ~docv:"DIR" ~doc)

let coverage =
  let doc =
    "Tells which summands of the behaviours never fired, which behaviours were never reached, which channels and \
     rules were never used. It explores all of the model once more, decided or not, and counts while it explores, \
     within the same bounds; half of the seconds are kept for it. Of what they cut off it says how much was \
     looked at."
  in
  Arg.(value & flag & info [ "coverage" ] ~doc)

let stats =
  let doc =
    "Tells what the run took: seconds of each phase, states and transitions a second, memory. The phases are \
     reading, exploring, looking for an invariant, and concluding: making verdicts and runs of what was \
     explored. To standard error, or as $(b,measured) in the JSON document. It varies from run to run."
  in
  Arg.(value & flag & info [ "stats" ] ~doc)

let sarif =
  let doc =
    "Writes errors, warnings, and the properties that are violated or undecided to $(docv), as SARIF 2.1.0, which \
     editors and code reviews show at their places. The steps of a witness are a code flow."
  in
  Arg.(value & opt (some string) None & info [ "sarif" ] ~docv:"FILE" ~doc)

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
  let doc =
    "Does without some of the ways to explore less: $(b,symmetry), $(b,translation), $(b,order), $(b,jump), \
     $(b,slice), $(b,drift), $(b,time), or $(b,all); separated by commas. None of them changes a verdict; \
     see REDUCTIONS."
  in
  let without off = List.filter (fun k -> not (List.exists (Reduction.equal k) (List.concat off))) Reduction.all in
  Term.(
    const (fun off -> without (List.concat off))
    $ Arg.(value & opt_all (list kind) [] & info [ "no-reduce" ] ~docv:"NAME,..." ~doc))

let order =
  let doc =
    "Which runs to show for $(b,possibly) and $(b,always): those with the fewest $(b,steps), or the earliest in \
     model $(b,time). The exploration goes in this order."
  in
  let orders = [ ("steps", State_graph.By_steps); ("time", By_time) ] in
  Arg.(value & opt (enum orders) State_graph.By_steps & info [ "shortest" ] ~docv:"ORDER" ~doc)

let compact =
  let doc =
    "Hash compaction: keeps a fingerprint of each state instead of the state, which takes about 5 bytes a state \
     less. Two states with one fingerprint are taken for one, so that nothing is proved by finding nothing: such \
     verdicts hold up to a bound, which names the probability that a state was left out. For $(b,always) and \
     $(b,possibly) without a bound of time, their own or $(b,--time); other properties are checked as ever. Room \
     is made for the states of $(b,--states) at once."
  in
  Arg.(value & flag & info [ "hash-compact" ] ~doc)

let where =
  let doc =
    "Of a model with parameters of which ranges are known ($(b,param x in [0, 6])): tells for each property for \
     which values it holds, exactly, and with which probability, if they are independent and uniform in their \
     ranges."
  in
  Arg.(value & flag & info [ "where" ] ~doc)

let smt =
  let doc =
    "Like $(b,--where); writes it to $(docv), as a script of SMT-LIB 2.6 that defines for each property where it \
     holds, where it fails, and where that is unknown."
  in
  Arg.(value & opt (some string) None & info [ "smt" ] ~docv:"FILE" ~doc)

let draw =
  let doc =
    "Like $(b,--where); draws it to $(docv), in SVG: the line of one parameter or the plane of two, in regions by \
     which properties hold there."
  in
  Arg.(value & opt (some string) None & info [ "draw" ] ~docv:"FILE" ~doc)

let axes =
  let doc = "The one or two parameters to $(b,--draw); by default the first ones." in
  Arg.(value & opt (list string) [] & info [ "axes" ] ~docv:"X,Y" ~doc)

let slice =
  let doc =
    "Draws the regions at this value of a parameter that is not shown. Of others it is shown whether it holds for \
     all of their values, for some, or for none."
  in
  Arg.(value & opt_all Options.override [] & info [ "slice" ] ~docv:"NAME=VALUE" ~doc)

let prove =
  let doc =
    "Looks for an invariant: a set of states that no run leaves, which may prove that something never happens \
     where exploring comes to no end. It looks briefly, then explores what that does not decide, and looks longer \
     where a bound ended this, all within the bounds. See PROOFS."
  in
  Arg.(value & flag & info [ "prove" ] ~doc)

let invariant =
  let doc =
    "Like $(b,--prove); writes the invariant that something rests on to $(docv): kinds of states, each with what \
     holds of its numbers. $(b,-) is standard output."
  in
  Arg.(value & opt (some string) None & info [ "invariant" ] ~docv:"FILE" ~doc)

let jobs =
  let doc =
    "How many processes explore. By default as many as there are cores, once it pays; with 1 it is this process \
     alone. Whatever it is, the report is the same, to the byte."
  in
  Arg.(
    value
    & opt (some (Options.integer ~least:1 ~most:1024 "number of processes from 1 to 1024")) None
    & info [ "j"; "jobs" ] ~docv:"J" ~doc)

let store =
  let doc =
    "Keeps the exploration in the folder $(docv) while it goes on, which is made if need be. After an \
     interruption, the same command goes on from there, and ends with the report of a run that was never \
     interrupted. See STORES."
  in
  Kept.option ~doc

let explored e (budget : Scc_verdicts.Budget.t) =
  let number = function None -> "default" | Some n -> string_of_int n in
  [
    ("what is kept", "explorations of scc check");
    ("--no-reduce", String.concat "," (List.filter_map (fun k ->
         if List.exists (Reduction.equal k) e.reductions then None else Some (Reduction.name k)) Reduction.all));
    ("--shortest", match e.order with State_graph.By_steps -> "steps" | By_time -> "time");
    ("--hash-compact", if e.compact then "given" else "not given");
    ("--depth", number budget.depth);
    ("--time", Option.fold ~none:"default" ~some:Scc_exact.Rat.to_string budget.time);
    ("--states", number budget.states);
    ("--bits", number budget.bits);
  ]

let term =
  let make witness coverage stats sarif reductions order compact where smt draw axes slice prove invariant full
      jobs store =
    let prove = prove || Option.is_some invariant in
    {
      witness; coverage; stats; sarif; reductions; order; compact; where; smt; draw; axes; slice; prove; invariant;
      full; jobs; store;
    }
  in
  Term.(
    const make $ witness $ coverage $ stats $ sarif $ reductions $ order $ compact $ where $ smt $ draw $ axes
    $ slice $ prove $ invariant
    $ Options.full
      "Tells runs in full: every step and every body, and numbers with all their digits; in JSON all steps of the \
       way to a state that was not explored."
    $ jobs $ store)
