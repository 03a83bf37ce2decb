open Cmdliner

type t = { witness : string option; coverage : bool; stats : bool; sarif : string option }

let witness =
  let doc =
    "Writes a schedule for each property that has a witness to the folder $(docv), which is made if need \
     be: $(docv)/$(i,PROPERTY).json. $(b,scc trace --schedule) replays it."
  in
  Arg.(value & opt (some string) None & info [ "witness" ] ~docv:"DIR" ~doc)

let coverage =
  let doc =
    "Tells which summands of the behaviours never fired, which behaviours were never reached, which channels and \
     rules were never used. It explores all of the model, within the same bounds once more, decided or not."
  in
  Arg.(value & flag & info [ "coverage" ] ~doc)

let stats =
  let doc =
    "Tells what the run took: seconds of each phase, states and transitions a second, memory. To standard error, \
     or as $(b,measured) in the JSON document. It varies from run to run."
  in
  Arg.(value & flag & info [ "stats" ] ~doc)

let sarif =
  let doc =
    "Writes errors, warnings, and the properties that are violated or undecided to $(docv), as SARIF 2.1.0, which \
     editors and code reviews show at their places. The steps of a witness are a code flow."
  in
  Arg.(value & opt (some string) None & info [ "sarif" ] ~docv:"FILE" ~doc)

let term =
  let make witness coverage stats sarif = { witness; coverage; stats; sarif } in
  Term.(const make $ witness $ coverage $ stats $ sarif)
