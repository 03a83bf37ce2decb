open Scc_base
open Scc_system

type color = Always | Never | Auto

type t = {
  out_color : bool;
  err_color : bool;
  terminal : bool;  (** standard error is one *)
  json : bool;
  mutable sources : Source.t list;
  mutable kept : Diag.t list;  (** newest first *)
  mutable faults : string list;  (** likewise *)
  mutable progressing : bool;
  mutable outputs : Outputs.t;
  mutable inputs : string list;  (** the files that have been read *)
  mutable lost : exn option;  (** why standard output is lost *)
  sink : (phase:bool -> string -> unit) option;  (** what takes the lines of progress, if they go elsewhere *)
}

exception Output_failed of Diag.t
exception Output_closed
exception Refused of string

let is_terminal fd = try Unix.isatty fd with Unix.Unix_error _ -> false

let make ?progress ~color ~json () =
  let plain =
    Sys.getenv_opt "NO_COLOR" <> None
    || match Sys.getenv_opt "TERM" with Some "dumb" -> true | _ -> false
  in
  let colored fd =
    match color with Always -> true | Never -> false | Auto -> is_terminal fd && not plain
  in
  {
    out_color = colored Unix.stdout;
    err_color = colored Unix.stderr;
    terminal = is_terminal Unix.stderr;
    json;
    sources = [];
    kept = [];
    faults = [];
    progressing = false;
    outputs = Outputs.none;
    inputs = [];
    lost = None;
    sink = progress;
  }

let is_json c = c.json
let fault c what = if not (List.mem what c.faults) then c.faults <- what :: c.faults
let faults c = List.rev c.faults
let add_source c s = c.sources <- s :: c.sources
let source c name = List.find_opt (fun s -> String.equal (Source.name s) name) c.sources

let output_failed name message =
  Output_failed
    (Diag.error Code.cannot_write (Span.of_file name) "cannot write: %s" message)

let refuse text = raise (Refused text)
let check c input = Option.iter refuse (Outputs.refusal c.outputs input)

let declare c outputs =
  c.outputs <- Result.fold ~ok:Fun.id ~error:refuse (Outputs.add c.outputs outputs);
  List.iter (check c) c.inputs

let reads c path =
  c.inputs <- path :: c.inputs;
  check c path

let lost c = c.lost

(* Standard output drops everything after its first failure. *)
let fail c e = if Outputs.some c.outputs then c.lost <- Some e else raise e

(* A closed pipe is the reader's choice, everything else is a failure. *)
let to_stdout c f =
  match f () with
  | () -> ()
  | exception Standard.Closed -> fail c Output_closed
  | exception Standard.Failed message -> fail c (output_failed "standard output" message)

let print c s = to_stdout c (fun () -> Standard.print s)
let flush c = to_stdout c Standard.flush

type style = Good | Bad | Doubtful | Strong | Faint

let styles = [ Good; Bad; Doubtful; Strong; Faint ]
let sgr = function Good -> "1;32" | Bad -> "1;31" | Doubtful -> "1;33" | Strong -> "1" | Faint -> "2"
let switch style = Printf.sprintf "\027[%sm" (sgr style)
let switch_off = "\027[0m"
let paint on style s = if on then switch style ^ s ^ switch_off else s
let styled c style s = paint c.out_color style s

let is_caret_line line =
  match String.index_opt line '|' with
  | Some i when String.length line > i + 1 ->
    let rest = String.trim (String.sub line (i + 1) (String.length line - i - 1)) in
    String.length rest > 0 && String.for_all (Char.equal '^') rest
  | _ -> false

let paint_line style head line =
  let n = String.length line and k = String.length head in
  let rec find i =
    if i + k > n then None else if String.equal (String.sub line i k) head then Some i else find (i + 1)
  in
  match find 0 with
  | Some i -> (
      match String.index_from_opt line i ']' with
      | Some j ->
        let before = String.sub line 0 i and after = String.sub line (j + 1) (n - j - 1) in
        before ^ paint true style (String.sub line i (j + 1 - i)) ^ after
      | None -> line)
  | None -> if is_caret_line line then paint true style line else line

let rendered c d =
  let text = Diag.render ~source:(source c) d in
  if not c.err_color then text
  else
    let style, head = if Diag.is_error d then (Bad, "error[") else (Doubtful, "warning[") in
    String.concat "\n" (List.map (paint_line style head) (String.split_on_char '\n' text))

let progress_lines () =
  let last = ref 0. in
  fun ~phase line ->
    let now = Unix.gettimeofday () in
    if phase || now -. !last >= 0.1 then begin
      if not phase then last := now;
      Standard.control (Printf.sprintf "progress: %s\n" (Visible.line line))
    end

let progress_done c =
  if c.progressing then begin
    c.progressing <- false;
    Standard.control "\r\027[K"
  end

let show c ~phase line =
  match c.sink with
  | Some put -> put ~phase line
  | None when c.terminal && not c.json ->
    c.progressing <- true;
    (* Without the switch, a line that is too long for the terminal would go on in the next. *)
    Standard.control ("\r\027[K\027[?7l" ^ Visible.line line ^ "\027[?7h")
  | None -> ()

let progress c line = show c ~phase:false line
let phase c line = show c ~phase:true line

(* The lines are {!Visible}.
   What was printed before comes before; where it cannot be written, the lines are there all the same. *)
let complain c lines =
  progress_done c;
  if not c.json then
    Fun.protect
      (fun () -> flush c)
      ~finally:(fun () -> Standard.control (String.concat "" lines))

let report c diagnostics =
  c.kept <- List.rev_append diagnostics c.kept;
  complain c (List.map (rendered c) diagnostics)

let kept c = List.rev c.kept

let note c line = complain c [ Visible.line line ^ "\n" ]

let with_output ?(pieces = false) c ~path f =
  match path with
  | Some path when not (String.equal path "-") ->
    if pieces then Whole_file.with_pieces path f else Whole_file.with_file path f
  | Some _ | None ->
    let result = f (print c) in
    flush c;
    Ok result

let with_main_output ?pieces c ~path f =
  let others = match path with Some path -> Outputs.others c.outputs path | None -> false in
  let made = ref None in
  let run put =
    let failed = ref None in
    let put text =
      if Option.is_none !failed then
        match put text with
        | () -> ()
        | exception (Whole_file.Failed _ as e) when others -> failed := Some e
    in
    made := Some (f put);
    Option.iter raise !failed
  in
  let written = with_output ?pieces c ~path run in
  (match (written, !made) with
   | Error _, None when others -> made := Some (f ignore)
   | _ -> ());
  (!made, written)

(* Colours are our own. *)
let switches = switch_off :: List.map switch styles
let tell c text = print c (Visible.text ~kept:(if c.out_color then switches else []) text)

let document c json =
  let text = Scc_json.Json.pretty json in
  Scc_system.Interruption.settle ();
  print c text;
  flush c

let answer c ~json ~text =
  if c.json then document c (json ())
  else begin
    tell c (text ());
    flush c
  end

let answer_and_write c ~json ~text write =
  if c.json then begin
    let* () = write () in
    Ok (document c (json ()))
  end
  else begin
    tell c (text ());
    flush c;
    write ()
  end
