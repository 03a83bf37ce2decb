open Scc_base
open Scc_notation
open Scc_verdicts
open Cmdliner

(* What is asked for by its name, or by the ending of the output; else the language of scc. *)
let target ~named ~output =
  match (named, Option.bind output Notation.of_name) with
  | Some n, _ | None, Some n -> n
  | None, None -> Notation.shape_calculus

(* In another notation things may nest deeper than the limits of the language allow. XML may have named characters
   by their numbers that change the direction of the translation. *)
let check_readable console ~from (notation : Notation.t) text =
  let source = Source.make ~name:"the translation" text in
  Console.add_source console source;
  if Direction.warnings from = [] then Console.report console (Direction.warnings source);
  Result.map ignore (notation.read source)

let translate console notation output path =
  let* source = Input.warned console path in
  let from = Notation.of_source source in
  let* read = from.read source in
  let* text = (notation : Notation.t).write read in
  let* () =
    if String.equal from.name notation.name then Ok ()
    else check_readable console ~from:source notation text
  in
  let* () = Result.listed (Console.with_output console ~path:output (fun put -> put text)) in
  Console.flush console;
  Ok Exit_code.Holds

let run color named output path =
  let console = Console.make ~color ~json:false () in
  let target = target ~named ~output in
  Guard.run ~outputs:(Outputs.file "-o" output) console (fun () -> translate console target output path)

(* The language of scc is the refined calculus, and is known by that as well. *)
let names =
  ("refined", Notation.shape_calculus) :: List.map (fun (n : Notation.t) -> (n.name, n)) Notation.all

let named =
  let doc = Printf.sprintf "The notation to write: %s (see NOTATIONS)." (Arg.doc_alts_enum names) in
  Arg.(value & opt (some (enum names)) None & info [ "to" ] ~docv:"NOTATION" ~doc)

let output =
  Options.output ~docv:"OUT"
    "Writes to $(docv) instead of standard output; without $(b,--to), the ending of its name selects the notation."

let file =
  Options.argument 0 ~docv:"FILE"
    "The model. The ending of its name selects the notation, or, without a name, the beginning of its text; \
     $(b,-) is standard input."

let man =
  let told (n : Notation.t) =
    `I ("$(b," ^ n.name ^ ")", n.told ^ ". Files: " ^ String.concat ", " n.extensions ^ ".")
  in
  [
    `S Manpage.s_description;
    `P
      "Writes a model in another notation: the same declarations, in the same order, and its comments. Nothing \
       is evaluated: loops, parameters and imports are kept, and imported files are not translated. Without \
       $(b,--to) and $(b,-o), the model is written in the language of scc.";
  ]
  @ (`S "NOTATIONS" :: List.map told Notation.all)
  @ Manual.diagnostics
  @ [
    `S Manpage.s_examples;
    `Pre "  scc translate hexokinase.sc --to xml";
    `Pre "  scc translate model.xml -o model.sc";
  ]

let command =
  Cmd.v
    (Cmd.info "translate" ~doc:"write a model in another notation" ~man ~exits:(Exits.man ()))
    Term.(const run $ Options.color $ named $ output $ file)
