open Scc_verdicts
open Cmdliner

let commands =
  [
    Check_command.command;
    Trace_command.command; Simulate_command.command; Estimate_command.command; Sweep_command.command;
    View_command.command;
    Serve_command.command;
    Export_command.command;
    Explore_command.command;
    Explain_command.command;
    Compare_command.command;
    Conform_command.command;
    Diff_command.command;
    Shape_command.command;
    Inflate_command.command;
    Decompose_command.command;
    Oracle_command.command;
    Lsp_command.command;
    Successors_command.command;
    Fmt_command.command;
    Translate_command.command;
  ]

let console = Console.make ~color:Never ~json:false ()

(* Manuals and versions are standard output, complaints about the command line standard error. *)
let help = Format.make_formatter (fun text from n -> Console.print console (String.sub text from n)) ignore

let complaints =
  Format.make_formatter (fun text from n -> Scc_system.Standard.complain (String.sub text from n)) ignore

(* A word such as -5, -1/2 or -.5: no option has such a name. *)
let is_negative word =
  let digit i = String.length word > i && word.[i] >= '0' && word.[i] <= '9' in
  String.length word > 1 && word.[0] = '-' && (digit 1 || (word.[1] = '.' && digit 2))

(* An option without its value. *)
let is_option word =
  String.length word > 1 && word.[0] = '-' && (not (String.contains word '=')) && not (is_negative word)

(* Cmdliner takes any word that begins with - for an option, but for one that is joined to its option. *)
let rec with_negatives = function
  | "--" :: _ as rest -> rest
  | option :: number :: rest when is_option option && is_negative number ->
    let long = String.length option > 2 && option.[1] = '-' in
    (option ^ (if long then "=" else "") ^ number) :: with_negatives rest
  | word :: rest -> word :: with_negatives rest
  | [] -> []

(* `scc help COMMAND` is `scc COMMAND --help`. *)
let arguments =
  match with_negatives (Array.to_list Sys.argv) with
  | scc :: "help" :: rest -> Array.of_list ((scc :: rest) @ [ "--help" ])
  | words -> Array.of_list words

(* A pager is for terminals, and has its own answer to signals. Elsewhere nobody would hear that it could not
   write. *)
let without_pager () =
  let asks word = String.length word >= 6 && String.equal (String.sub word 0 6) "--help" in
  if Array.exists asks arguments then begin
    Scc_system.Interruption.heed ();
    if not (Console.is_terminal Unix.stdout) then Unix.putenv "TERM" "dumb"
  end

let evaluate () : Exit_code.t =
  let info =
    Cmd.info "scc" ~version:Version.told ~doc:"interpreter and model checker for the Shape Calculus"
      ~man:Manual.scc ~exits:(Exits.man ())
  in
  match Cmd.eval_value ~argv:arguments ~help ~err:complaints ~catch:false (Cmd.group info commands) with
  | Ok (`Ok code) -> code
  | Ok (`Version | `Help) -> Holds
  | Error (`Parse | `Term) -> Usage
  | Error `Exn -> Bug

let main () =
  Scc_base.Memory.spare_tables ();
  without_pager ();
  let code = Guard.around console (fun () -> Ok (evaluate ())) in
  let finish () =
    Format.pp_print_flush help ();
    Console.flush console;
    Ok Exit_code.Holds
  in
  Exit_code.to_int (Exit_code.worst [ code; Guard.run console finish ])

module Compare_json = Compare_json
module Inflate_command = Inflate_command
