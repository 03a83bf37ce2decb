open Scc_base
open Scc_data

let unexplored = "unexplored"

(* A slip in the header is not to take all memory. *)
let most_states = 200_000_000

exception Fault of int * int * string  (* from, upto, what *)

let fault start stop fmt = Printf.ksprintf (fun s -> raise (Fault (start, stop, s))) fmt

(* The line from [start] to [stop]; a cursor moves over it. *)
type line = { text : string; mutable at : int; stop : int }

let is_space = function ' ' | '\t' | '\r' -> true | _ -> false

let rec skip l = if l.at < l.stop && is_space l.text.[l.at] then (l.at <- l.at + 1; skip l)

let expect l c =
  skip l;
  if l.at < l.stop && l.text.[l.at] = c then l.at <- l.at + 1
  else fault l.at (min l.stop (l.at + 1)) "`%c` is missing here" c

let is_digit c = c >= '0' && c <= '9'

let number l what =
  skip l;
  let start = l.at in
  let rec digits n =
    if l.at < l.stop && is_digit l.text.[l.at] then begin
      let n = (10 * n) + Char.code l.text.[l.at] - Char.code '0' in
      l.at <- l.at + 1;
      if n > Int_array.max_value then fault start l.at "%s is greater than %d" what Int_array.max_value;
      digits n
    end
    else n
  in
  let n = digits 0 in
  if l.at = start then fault start (min l.stop (start + 1)) "%s is to be written here" what;
  n

let finish l =
  skip l;
  if l.at < l.stop then fault l.at l.stop "more than fits the line"

let header l =
  skip l;
  if not (l.at + 3 <= l.stop && String.equal (String.sub l.text l.at 3) "des") then
    fault l.at l.stop "the file does not begin with `des (initial, transitions, states)`";
  l.at <- l.at + 3;
  expect l '(';
  let initial = number l "the initial state" in
  let after_initial = l.at in
  expect l ',';
  let transitions = number l "the number of transitions" in
  expect l ',';
  let states = number l "the number of states" in
  expect l ')';
  finish l;
  if states > most_states then fault l.stop l.stop "more than %d states" most_states;
  if initial >= states then
    fault (after_initial - 1) after_initial "the initial state is not below the number of states, %d" states;
  (initial, transitions, states)

let state l states what =
  skip l;
  let start = l.at in
  let n = number l what in
  if n >= states then fault start l.at "state %d is not below the number of states, %d" n states;
  n

(* The label stands between the first comma and the last one: it may hold commas itself. *)
let label l =
  skip l;
  let start = l.at in
  let comma =
    match String.rindex_from_opt l.text (l.stop - 1) ',' with
    | Some i when i >= start -> i
    | _ -> fault start l.stop "no `, state)` after the label"
  in
  let rec trimmed stop = if stop > start && is_space l.text.[stop - 1] then trimmed (stop - 1) else stop in
  let stop = trimmed comma in
  if stop = start then fault start (start + 1) "the label is empty";
  l.at <- comma;
  if l.text.[start] <> '"' then String.sub l.text start (stop - start)
  else if stop - start >= 2 && l.text.[stop - 1] = '"' then String.sub l.text (start + 1) (stop - start - 2)
  else fault start stop "the label does not end with its quote"

let is_silent = function "tau" | "i" -> true | _ -> false

let transition b unknown states l =
  expect l '(';
  let source = state l states "the source" in
  expect l ',';
  let text = label l in
  expect l ',';
  let target = state l states "the target" in
  expect l ')';
  finish l;
  if String.equal text unexplored then Bits.add unknown source
  else
    let label = Graph.intern b (if is_silent text then Graph.tau else text) in
    Graph.add b ~source ~label ~target

(* Each line that is not empty, from an offset on. *)
let rec lines text start f =
  if start < String.length text then begin
    let stop = Option.value ~default:(String.length text) (String.index_from_opt text start '\n') in
    let l = { text; at = start; stop } in
    skip l;
    if l.at < stop then f l;
    lines text (stop + 1) f
  end

let parse text =
  let b = Graph.builder () in
  let head = ref None and count = ref 0 in
  lines text 0 (fun l ->
      match !head with
      | None ->
        let (_, _, states) as h = header l in
        head := Some (h, Bits.create states, l.stop)
      | Some ((_, transitions, states), unknown, _) ->
        if !count = transitions then
          fault l.at l.stop "a transition more than the %d of the first line" transitions;
        incr count;
        transition b unknown states l);
  match !head with
  | None -> fault 0 (String.length text) "the file is empty"
  | Some ((initial, transitions, states), unknown, stop) ->
    if !count < transitions then
      fault 0 stop "%d transitions were to follow, and %d do" transitions !count;
    Graph.finish b ~size:states ~initial ~unknown:(Bits.mem unknown)

let read ~file text =
  match parse (Source.blank_mark text) with
  | g -> Ok g
  | exception Fault (start, stop, message) ->
    Error (Diag.error Code.bad_graph (Span.make ~file ~start ~stop) "%s" message)

let write ?(cadp = false) (g : Graph.t) put =
  let open_ = ref 0 in
  for s = 0 to g.size - 1 do
    if not (Graph.known g s) then incr open_
  done;
  let quoted label text =
    if cadp && Graph.is_tau label then "i"
    else "\"" ^ String.map (function '"' -> '\'' | '\x00' .. '\x1f' | '\x7f' -> ' ' | c -> c) text ^ "\""
  in
  let quoted = Array.mapi quoted g.labels in
  put (Printf.sprintf "des (%d, %d, %d)\n" g.initial (Graph.edges g + !open_) g.size);
  for s = 0 to g.size - 1 do
    Graph.iter g s (fun label target -> put (Printf.sprintf "(%d, %s, %d)\n" s quoted.(label) target));
    if not (Graph.known g s) then put (Printf.sprintf "(%d, \"%s\", %d)\n" s unexplored s)
  done
