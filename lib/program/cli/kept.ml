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
  Result.listed (Store.openly folder ~identity ~warn:(tell console))

let code = List.map (fun (_ : Diag.t) -> Scc_verdicts.Exit_code.Unwritten)
let conclude console = List.iter (tell console)

let option ~doc = Arg.(value & opt (some Options.named) None & info [ "store" ] ~docv:"DIR" ~doc)
