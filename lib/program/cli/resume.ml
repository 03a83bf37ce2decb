open Scc_base

let file ~output ~resume = match output with None -> resume | Some _ -> output

let conflict ~resume ~store ~part ~lines =
  match resume with
  | _ when Option.is_some store && Option.is_some part -> Some "--store does not go with --part"
  | Some _ when Option.is_some store -> Some "--resume does not go with --store"
  | Some _ when not lines -> Some "--resume goes on with JSON Lines: --format jsonl"
  | Some _ when Option.is_some part -> Some "--resume does not go with --part"
  | Some _ | None -> None

let bad path format =
  Printf.ksprintf
    (fun text -> Error [ Diag.error Code.bad_trace (Span.of_file path) "%s" text ])
    format

type line = Whole | Interrupted | Other

(* What is to be made anew is what a line says to be interrupted. *)
let kind member number line =
  match Yojson.Safe.from_string line with
  | `Assoc members -> (
      match (List.assoc_opt member members, List.assoc_opt "interrupted" members) with
      | Some (`Int n), Some (`Bool true) when n = number -> Interrupted
      | Some (`Int n), _ when n = number -> Whole
      | _, _ -> Other)
  | _ -> Other
  | exception Yojson.Json_error _ -> Other

(* A last line without its end is none. *)
let lines console ~path ~header ~member ~what =
  let* source = Result.listed (Input.read ~max_bytes:max_int console path) in
  match String.split_on_char '\n' (Source.text source) with
  | first :: rest when String.equal (first ^ "\n") header ->
    let rec count n = function
      | [] | [ _ ] -> Ok n
      | line :: rest -> (
          match kind member n line with
          | Whole -> count (n + 1) rest
          | Interrupted -> Ok n
          | Other -> bad path "line %d is not that of %s %d" (n + 2) member n)
    in
    let* n = count 0 rest in
    let kept = List.filteri (fun i _ -> i <= n) (first :: rest) in
    Ok (n, String.concat "\n" kept ^ "\n")
  | _ -> bad path "this file is not of the same %s: its first line would be `%s`" what (String.trim header)
