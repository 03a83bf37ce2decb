open Scc_exact
open Cmdliner

let rational =
  let parse s =
    match Rat.of_literal s with
    | Ok q -> Ok q
    | Error Malformed -> Error (`Msg (Printf.sprintf "`%s' is no number such as 3, 1/4, 0.125 or 1e-3" s))
    | Error Too_large -> Error (`Msg "the number is too large")
    | Error Zero_denominator -> Error (`Msg (Printf.sprintf "`%s' has a zero denominator" s))
  in
  Arg.conv ~docv:"NUMBER" (parse, fun ppf q -> Format.pp_print_string ppf (Rat.to_string q))

let not_negative what =
  let parse s =
    match Arg.conv_parser rational s with
    | Ok q when Rat.sign q < 0 -> Error (`Msg (Printf.sprintf "`%s' is negative, and no %s" s what))
    | result -> result
  in
  Arg.conv ~docv:"NUMBER" (parse, Arg.conv_printer rational)

let integer ?(least = min_int) ?(most = max_int) what =
  let parse s =
    match int_of_string_opt s with
    | Some n when least <= n && n <= most -> Ok n
    | Some _ | None -> Error (`Msg (Printf.sprintf "`%s' is no %s" s what))
  in
  Arg.conv ~docv:"N" (parse, Format.pp_print_int)

let transitions = integer ~least:0 "number of transitions"

let model_file =
  let doc = "The model, a $(b,.sc) file; $(b,-) reads it from standard input." in
  Arg.(required & pos 0 (some string) None & info [] ~docv:"MODEL" ~doc)

let override =
  let parse s =
    match String.index_opt s '=' with
    | Some i when i > 0 -> (
        let name = String.sub s 0 i in
        let value = String.sub s (i + 1) (String.length s - i - 1) in
        match Arg.conv_parser rational value with
        | Ok q -> Ok (name, q)
        | Error _ as e -> e)
    | _ -> Error (`Msg (Printf.sprintf "`%s' is not of the form name=value" s))
  in
  let print ppf (name, q) = Format.fprintf ppf "%s=%s" name (Rat.to_string q) in
  Arg.conv ~docv:"NAME=VALUE" (parse, print)

let overrides =
  let doc = "Gives the parameter $(i,NAME) of the model the value $(i,VALUE), a rational. Repeatable." in
  Arg.(value & opt_all override [] & info [ "D"; "define" ] ~docv:"NAME=VALUE" ~doc)

let sdocs = Manpage.s_common_options

let color =
  let doc = "When to use colours: $(b,auto) (when writing to a terminal), $(b,always) or $(b,never)." in
  let choices = Console.[ ("auto", Auto); ("always", Always); ("never", Never) ] in
  Arg.(value & opt (enum choices) Console.Auto & info [ "color" ] ~docv:"WHEN" ~doc ~docs:sdocs)

let json =
  let doc =
    "Prints one JSON document to standard output: the report, or the diagnostics when there can be no \
     report. Nothing is printed to standard error. The schemas are in $(b,specs/schema)."
  in
  Arg.(value & flag & info [ "json" ] ~doc)

let full doc = Arg.(value & flag & info [ "full" ] ~doc)

let diagnostics_man =
  [
    `S "DIAGNOSTICS";
    `P
      "What is wrong with an input is told on standard error with its place, a stable code such as \
       $(b,SC0201), an excerpt of the text and, where it helps, a hint. Several faults are told in one run.";
  ]
