open Scc_base
open Scc_verdicts
open Cmdliner

type mode = Print | Check | In_place

let formatted console path =
  let* source = Input.warned console path in
  let* after = Scc_notation.Notation.canonical source in
  Ok (Source.text source, after)

let one console mode path =
  let* before, after = formatted console path in
  match mode with
  | Print ->
    Console.print console after;
    Ok Exit_code.Holds
  | Check when String.equal before after -> Ok Exit_code.Holds
  | Check ->
    Console.print console (Visible.line path ^ "\n");
    Ok Exit_code.Violated
  | In_place when String.equal before after -> Ok Exit_code.Holds
  | In_place ->
    let* () = Result.listed (Whole_file.with_file path (fun put -> put after)) in
    Ok Exit_code.Holds

let run color mode paths =
  let console = Console.make ~color ~json:false () in
  let in_place = match mode with In_place -> true | Print | Check -> false in
  if in_place && List.exists (String.equal "-") paths then
    Guard.usage "standard input cannot be rewritten: `-' does not go with --inplace"
  else
    Guard.run console (fun () ->
        let file path =
          match one console mode path with
          | Ok code -> code
          | Error diagnostics -> Guard.invalid console diagnostics
        in
        let codes = List.map file paths in
        Console.flush console;
        Ok (Exit_code.worst codes))

let mode =
  let check =
    let doc = "Prints the names of the files that are not in canonical layout; exit 1 if there are any." in
    (Check, Arg.info [ "check" ] ~doc)
  in
  let in_place =
    let doc = "Rewrites the files." in
    (In_place, Arg.info [ "i"; "inplace" ] ~doc)
  in
  Arg.(value & vflag Print [ check; in_place ])

let files =
  let doc = "The models; $(b,-) is standard input." in
  Arg.(non_empty & pos_all string [] & info [] ~docv:"MODEL" ~doc)

let command =
  let exits =
    Exits.man () ~told:[ (Violated, "with $(b,--check), if some file is not in canonical layout.") ]
  in
  Cmd.v
    (Cmd.info "fmt" ~doc:"print models in canonical layout" ~man:Manual.fmt ~exits)
    Term.(const run $ Options.color $ mode $ files)
