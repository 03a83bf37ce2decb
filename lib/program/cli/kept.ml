open Scc_base
open Scc_exact
open Scc_store
open Cmdliner

(* Of two builds that call themselves by one version, one may have a fault that the other has not: what one has
   found is not taken over by the other. *)
let identity ~digest ~parameters options =
  let values = List.map (fun (name, q) -> ("parameter " ^ name, Rat.to_string q)) parameters in
  [ ("scc", Version.told); ("the build of scc", Scc_build.Build.digest); ("the model", digest) ] @ values @ options

let tell console d =
  if Console.is_json console then Guard.complain_of console d
  else Console.report console [ d ]

let openly console ~folder identity =
  Result.map_error (fun d -> [ d ]) (Store.openly folder ~identity ~warn:(tell console))

let code = List.map (fun (_ : Diag.t) -> Scc_verdicts.Exit_code.Unwritten)
let conclude console = List.iter (tell console)

let option ~doc = Arg.(value & opt (some Options.named) None & info [ "store" ] ~docv:"DIR" ~doc)

let man =
  [
    `S "STORES";
    `P
      "With $(b,--store) finished work goes to a folder at once. After Ctrl-C, $(b,kill -9) or a power cut the \
       same command resumes, and ends with the bytes of a run that was never interrupted. At most a second of \
       work is lost. If the store cannot be written any more, as on a full disk, a warning says so at once. The \
       work then continues without it, and the exit code is 74. A store belongs to one model, one build of scc \
       and one set of options. A store of something else is refused, with the difference. Only one process at a \
       time can use it.";
  ]
