open Scc_exact
open Scc_calculus
open Cmdliner

let rational =
  let parse s =
    match Rat.of_literal s with
    | Ok q -> Ok q
    | Error Malformed -> Error (`Msg (Printf.sprintf "`%s' is no number such as 3, 1/4, 0.125 or 1e-3" s))
    | Error Too_large ->
      let most = Printf.sprintf "at most %d digits each above and below the line" Rat.max_digits in
      Error (`Msg ("a number is too large: " ^ most))
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

let positive what =
  let parse s =
    match Arg.conv_parser rational s with
    | Ok q when Rat.sign q <= 0 -> Error (`Msg (Printf.sprintf "`%s' is not positive, and no %s" s what))
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

(* {1 Making options} *)

let flag ?docs names doc = Arg.(value & flag & info names ~doc ?docs)
let maybe ?docs kind names ~docv doc = Arg.(value & opt (some kind) None & info names ~docv ~doc ?docs)
let default ?docs kind otherwise names ~docv doc = Arg.(value & opt kind otherwise & info names ~docv ~doc ?docs)
let repeated kind names ~docv doc = Arg.(value & opt_all kind [] & info names ~docv ~doc)
let argument index ~docv doc = Arg.(required & pos index (some string) None & info [] ~docv ~doc)

(* {1 Outputs} *)

let output ?(docv = "FILE") doc =
  let doc = doc ^ " $(b,-) stands for standard output." in
  Arg.(value & opt (some string) None & info [ "o"; "output" ] ~docv ~doc)

let named =
  let parse = function
    | "-" -> Error (`Msg "`-' stands for standard input or output: a name is needed here")
    | path -> Ok path
  in
  Arg.conv ~docv:"FILE" (parse, Format.pp_print_string)

let transitions = integer ~least:0 "number of transitions"
let processes = integer ~least:1 ~most:1024 "number of processes from 1 to 1024"

let model_file =
  argument 0 ~docv:"MODEL" "The model, a $(b,.sc) file; $(b,-) reads it from standard input."

(* What is given for a name, as [value] reads and prints it. *)
let for_name ~docv value print =
  let parse s =
    match String.index_opt s '=' with
    | Some i when i > 0 ->
      let name = String.sub s 0 i in
      Result.map (fun v -> (name, v)) (value (String.sub s (i + 1) (String.length s - i - 1)))
    | _ -> Error (`Msg (Printf.sprintf "`%s' is not of the form name=value" s))
  in
  Arg.conv ~docv (parse, fun ppf (name, v) -> Format.fprintf ppf "%s=%s" name (print v))

(* {1 Ranges} *)

type given = Value of Rat.t | Within of Ranges.bound * Ranges.bound

let between open_ low high close =
  match (Arg.conv_parser rational (String.trim low), Arg.conv_parser rational (String.trim high)) with
  | Ok low, Ok high ->
    let bound value included = { Ranges.value; included } in
    Ok (Within (bound low (open_ = '['), bound high (close = ']')))
  | (Error _ as e), _ | _, (Error _ as e) -> e

(* The text before and after the first place of [by], which is a text of one or two bytes. *)
let cut s by =
  let k = String.length by in
  let rec from i =
    if i + k > String.length s then None
    else if String.equal (String.sub s i k) by then
      Some (String.sub s 0 i, String.sub s (i + k) (String.length s - i - k))
    else from (i + 1)
  in
  from 0

let no_range s = Error (`Msg (Printf.sprintf "`%s' is no range such as [1, 3) or [0, 1/2]" s))

(* How loops and the grid of a sweep write values one after the other. *)
let several s =
  match List.find_map (cut s) [ ".."; ":"; "," ] with
  | None -> None
  | Some (low, rest) ->
    let high = match cut rest ":" with Some (high, _) -> high | None -> rest in
    Some
      (Printf.sprintf
         "`%s' are values one after the other, as scc sweep takes them: a range of all numbers between is \
          written [%s,%s]"
         s (String.trim low) (String.trim high))

let is_bracketed s =
  let n = String.length s in
  n > 2 && (s.[0] = '[' || s.[0] = '(') && (s.[n - 1] = ']' || s.[n - 1] = ')')

let parse_value s =
  if is_bracketed s then
    Error (`Msg (Printf.sprintf "`%s' is a range, as scc check takes them, and no value such as 3 or 1/4" s))
  else match several s with Some why -> Error (`Msg why) | None -> Arg.conv_parser rational s

let override = for_name ~docv:"NAME=VALUE" parse_value Rat.to_string

let overrides =
  repeated override [ "D"; "define" ] ~docv:"NAME=VALUE"
    "Gives the parameter $(i,NAME) of the model the value $(i,VALUE), a rational. Repeatable."

let parse_given s =
  if is_bracketed s then
    match cut (String.sub s 1 (String.length s - 2)) "," with
    | Some (low, high) -> between s.[0] low high s.[String.length s - 1]
    | None -> no_range s
  else if String.exists (String.contains "[]()") s then no_range s
  else Result.map (fun q -> Value q) (parse_value s)

let given_to_string = function
  | Value q -> Rat.to_string q
  | Within (low, high) ->
    Printf.sprintf "%s%s,%s%s"
      (if low.included then "[" else "(")
      (Rat.to_string low.value) (Rat.to_string high.value)
      (if high.included then "]" else ")")

type definitions = {
  values : (string * Rat.t) list;
  narrowed : (string * (Ranges.bound * Ranges.bound)) list;
}

let definitions =
  let doc =
    "Gives the parameter $(i,NAME) of the model the value $(i,VALUE), a rational. If the parameter has a range, \
     it can be narrowed instead: to $(b,[1,3]), or to $(b,[1,3\\)), where a round bracket excludes an end. \
     Repeatable."
  in
  let given = for_name ~docv:"NAME=VALUE" parse_given given_to_string in
  let values = List.filter_map (function name, Value q -> Some (name, q) | _, Within _ -> None) in
  let narrowed = List.filter_map (function name, Within (a, b) -> Some (name, (a, b)) | _, Value _ -> None) in
  let split given = { values = values given; narrowed = narrowed given } in
  Term.(const split $ Arg.(value & opt_all given [] & info [ "D"; "define" ] ~docv:"NAME=VALUE" ~doc))

let sdocs = Manpage.s_common_options

let color =
  let doc = "When to use colours: $(b,auto) (when writing to a terminal), $(b,always) or $(b,never)." in
  let choices = Console.[ ("auto", Auto); ("always", Always); ("never", Never) ] in
  Arg.(value & opt (enum choices) Console.Auto & info [ "color" ] ~docv:"WHEN" ~doc ~docs:sdocs)

let progress =
  let doc =
    "Writes lines of progress to standard error, at most ten a second, also if it is no terminal, and with \
     $(b,--json). Each begins with $(b,progress:)."
  in
  let lines on = if on then Some (Console.progress_lines ()) else None in
  Term.(const lines $ Arg.(value & flag & info [ "progress" ] ~doc ~docs:sdocs))

let json =
  flag [ "json" ]
    "Prints one JSON document to standard output: the report, or the diagnostics if there can be no report. \
     Nothing is printed to standard error. The schemas are in $(b,specs/schema)."

let full doc =
  let doc =
    doc
    ^ " Without it long numbers are decimals: after $(b,~) the nearest one with so many digits, with an error of \
       at most half a unit of the last digit; without $(b,~) the number itself."
  in
  Arg.(value & flag & info [ "full" ] ~doc)
