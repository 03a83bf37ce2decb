open Scc_base
open Scc_exact
module Engine = Parser.MenhirInterpreter

let max_errors = 20

(* {1 One run of the parser} *)

type failure = {
  index : int;  (* of the token refused *)
  sentence : string;  (* what was expected *)
  accepts : Parser.token -> bool;  (* whether another token would have been taken there *)
  name_goes_on : bool;  (* a name would have been taken in its place, and what follows it after the name *)
  name_before : bool;  (* a name would have been taken in place of the token before, and this one after it *)
}

let position file offset = { Lexing.pos_fname = file; pos_lnum = 1; pos_bol = 0; pos_cnum = offset }

let sentence env =
  match Parser_messages.message (Engine.current_state_number env) with
  | s -> String.concat " " (String.split_on_char '\n' (String.trim s))
  | exception Not_found -> Bug.fail __POS__ "a state of the parser has no message"

(* Whether the parser would take a name in place of the token [i], and then the token after it. *)
let name_instead (t : Tokens.t) place checkpoint i =
  let rec settled = function
    | (Engine.Shifting _ | AboutToReduce _) as c -> settled (Engine.resume c)
    | c -> c
  in
  match checkpoint with
  | Engine.InputNeeded _ -> (
      match settled (Engine.offer checkpoint (Parser.NAME "", place i, place i)) with
      | InputNeeded _ as next -> Engine.acceptable next t.tokens.(i + 1).token (place (i + 1))
      | Shifting _ | AboutToReduce _ | HandlingError _ | Accepted _ | Rejected -> false)
  | Shifting _ | AboutToReduce _ | HandlingError _ | Accepted _ | Rejected -> false

(* Reads from the token [first] on. *)
let run (t : Tokens.t) start first =
  let place i = position t.file t.tokens.(i).start in
  (* [asked] waits for the token read last, [before] for the one before it. *)
  let rec loop i before asked checkpoint =
    match checkpoint with
    | Engine.InputNeeded _ ->
      let token = t.tokens.(i) in
      loop (i + 1) asked checkpoint
        (Engine.offer checkpoint (token.token, place i, position t.file token.stop))
    | Shifting _ | AboutToReduce _ -> loop i before asked (Engine.resume checkpoint)
    | HandlingError env ->
      let index = i - 1 in
      let accepts token = Engine.acceptable asked token (place index) in
      let name_goes_on = index + 1 < Array.length t.tokens && name_instead t place asked index in
      let name_before = index > first && name_instead t place before (index - 1) in
      Error { index; sentence = sentence env; accepts; name_goes_on; name_before }
    | Accepted v -> Ok v
    | Rejected -> Bug.fail __POS__ "the parser went on after an error"
  in
  let checkpoint = start (place first) in
  loop first checkpoint checkpoint checkpoint

(* {1 What to say} *)

let shown (source : Source.t) (span : Span.t) =
  let text = String.sub (Source.text source) span.start (span.stop - span.start) in
  if String.length text <= 40 then text else String.sub text 0 (Utf8.boundary text 37) ^ "..."

let adjacent (t : Tokens.t) i = i > 0 && t.tokens.(i - 1).stop = t.tokens.(i).start

(* The words of the language that a name may have been meant for: those that would do where it stands. Not
   the shortest, which are near to every short name. *)
let misspelt accepts name =
  let fits (word, token) = if String.length word > 2 && accepts token then Some word else None in
  Diag.suggest name (List.filter_map fits Lexer.words)

(* A misspelt word is often taken for a name, and what comes after it refused. *)
let misspelt_before (t : Tokens.t) i =
  match if i > 0 then t.tokens.(i - 1).token else EOF with
  | NAME n when String.length n > 3 -> misspelt (fun _ -> true) n
  | _ -> None

(* Words that are nowhere names, or not where an operator can stand. *)
let is_word = Tokens.is_word

(* Words that ask for something after them, which is what is missing when they are followed by something else. *)
let asks : Parser.token -> bool = function
  | NOT | IF | FORALL | EXISTS | POSSIBLY | ALWAYS | EVENTUALLY | MINUS -> true
  | _ -> false

let quantifying : Parser.token -> string option = function A -> Some "A" | E -> Some "E" | _ -> None

let no_name text = Some (Printf.sprintf "`%s` is a word of the language and cannot be a name" text)

(* A word where a name was meant: the one that is refused, or the one before it, which was taken for the word
   that it is. *)
let meant_as_name (t : Tokens.t) source (f : failure) =
  let text i = shown source (Tokens.span t i) in
  let refused = text f.index in
  if is_word refused && f.accepts (NAME "") && ((not t.restart.(f.index)) || f.name_goes_on) then
    match t.tokens.(f.index).token with
    | AF | AG | AX | EF | EG | EX | NAME _ -> None
    | _ -> no_name refused
  else if f.name_before && is_word (text (f.index - 1)) && not (asks t.tokens.(f.index - 1).token) then
    no_name (text (f.index - 1))
  else None

let product_hint = "a product is written with `*`, as in `2*i`"

let joined_hint hint =
  match String.split_on_char '`' hint with [ ""; word; " is one word" ] -> Some word | _ -> None

(* `compound Wall = {`, `shape Brick(a) = {`: what is declared with an `=` before its bracket. *)
let braced (t : Tokens.t) index =
  let rec declared i =
    match t.tokens.(i).token with
    | COMPOUND -> Some "a compound has no `=` before `{`, as in `compound Wall { part a : SHAPE mass 1 }`"
    | SHAPE -> Some "a shape has no `=` before `{`, as in `shape Cube { vertices … faces … }`"
    | _ -> if i = 0 || t.restart.(i) then None else declared (i - 1)
  in
  match t.tokens.(index).token with
  | LBRACE when index > 1 && t.tokens.(index - 1).token = EQ -> declared (index - 2)
  | _ -> None

let hint (t : Tokens.t) source (f : failure) =
  let after_number =
    adjacent t f.index && (match t.tokens.(f.index - 1).token with NUMBER _ -> true | _ -> false)
  in
  let before = if f.index > 0 then t.tokens.(f.index - 1).token else EOF in
  match t.tokens.(f.index).token with
  | token when after_number && Tokens.can_be_name token ->
    Some product_hint
  | LBRACE when Option.is_some (braced t f.index) -> braced t f.index
  | DOT when after_number -> Some "a decimal point is followed by a digit"
  | DOT when f.accepts (NUMBER Rat.one) -> Some "a number begins with a digit, as in `0.5`"
  | LETTER l when Option.is_some (quantifying before) ->
    Option.map (fun q -> Printf.sprintf "`%s%s` is one word" q l) (quantifying before)
  | NAME n ->
    (match misspelt f.accepts n with None -> misspelt_before t f.index | found -> found)
  | _ -> (
      match meant_as_name t source f with
      | Some hint -> Some hint
      | None -> if f.accepts (NAME "") then None else misspelt_before t f.index)

(* The bracket that is still open where reading failed, when it is never closed. *)
let unclosed (t : Tokens.t) source first index =
  let rec find i =
    if i < first then []
    else if t.unclosed.(i) then
      let span = Tokens.span t i in
      [ (span, Printf.sprintf "this `%s` is not closed" (shown source span)) ]
    else find (if t.opening.(i) >= 0 then t.opening.(i) - 1 else i - 1)
  in
  find (index - 1)

let diagnose (t : Tokens.t) source first (f : failure) =
  let span = Tokens.span t f.index in
  let what =
    match t.tokens.(f.index).token with
    | EOF -> "the text ends here"
    | _ -> Printf.sprintf "`%s` does not fit here" (shown source span)
  in
  let notes = unclosed t source first f.index in
  Diag.error ~notes ?hint:(hint t source f) Code.syntax span "%s: %s" what f.sentence

(* {1 Going on after an error} *)

(* A closing bracket of what began before reading started again, and whatever follows text that is not of the
   language, are consequences of errors already told. *)
let follows (t : Tokens.t) first (f : failure) =
  t.tokens.(f.index).after_fault || (t.opening.(f.index) >= 0 && t.opening.(f.index) < first)

let next_start (t : Tokens.t) first (f : failure) =
  let rec find i =
    if i >= Array.length t.tokens then None else if t.restart.(i) then Some i else find (i + 1)
  in
  (* A word that was meant as a name begins nothing. *)
  find (max (first + 1) (if f.name_goes_on then f.index + 1 else f.index))

let all_failures t source start =
  let rec loop first found count =
    match run t start first with
    | Ok v -> (Some v, found)
    | Error f ->
      let found, count =
        if follows t first f then (found, count) else (diagnose t source first f :: found, count + 1)
      in
      (match next_start t first f with
       | Some next when count < max_errors -> loop next found count
       | Some _ | None -> (None, found))
  in
  loop 0 [] 0

let finish errors = Error (Scc_data.Lists.take max_errors (List.sort_uniq Diag.compare errors))

let of_tokens (t : Tokens.t) source start =
  if Tokens.hopeless t || List.length t.faults >= Tokens.max_faults then finish t.faults
  else
    match (all_failures t source start, t.faults) with
    | (Some v, []), [] -> Ok v
    | (_, errors), faults -> finish (List.rev_append faults errors)

let is_empty (t : Tokens.t) = Array.length t.tokens = 1

let with_trivia ?(tokens = Tokens.read ?rewrite:None) source =
  let t = tokens source in
  match of_tokens t source Parser.Incremental.model with
  | Error errors -> Error errors
  | Ok _ when is_empty t ->
    let span = Span.of_file t.file in
    finish
      [ Diag.error Code.empty_model span "this model declares nothing"
          ~hint:"a model declares at least one `process`" ]
  | Ok model -> Ok (model, t.trivia)

(* {1 Piece by piece} *)

(* For each opening bracket that is closed the index of its closing one; [-1] elsewhere. *)
let closing (t : Tokens.t) =
  let closing = Array.make (Array.length t.tokens) (-1) in
  Array.iteri (fun i o -> if o >= 0 then closing.(o) <- i) t.opening;
  closing

(* The tokens from [first] up to [last], which is left out, as a text. *)
let piece (t : Tokens.t) first last =
  let stop = t.tokens.(last - 1).stop in
  let finish : Tokens.token = { token = EOF; start = stop; stop; after_fault = false } in
  { t with tokens = Array.append (Array.sub t.tokens first (last - first)) [| finish |] }

let readable ?(tokens = Tokens.read ?rewrite:None) source =
  let t = tokens source in
  if Tokens.hopeless t then []
  else
    match run t Parser.Incremental.model 0 with
    | Ok model -> model
    | Error _ ->
      let closing = closing t and count = Array.length t.tokens - 1 in
      let rec start i = if i >= count || t.restart.(i) then Int.min i count else start (i + 1) in
      (* Where a declaration ends: before the next one that is not within its brackets, or the end of its loop. *)
      let rec stop first i =
        let of_loop () = match t.tokens.(i).token with RBRACE -> t.opening.(i) < first | _ -> false in
        if i >= count || t.restart.(i) || of_loop () then Int.min i count
        else stop first (if closing.(i) >= 0 then closing.(i) + 1 else i + 1)
      in
      (* A loop that has a fault is looked into. *)
      let rec read items first =
        if first >= count then List.rev items
        else
          let last = stop first (first + 1) in
          match run (piece t first last) Parser.Incremental.model 0 with
          | Ok more -> read (List.rev_append more items) (start last)
          | Error _ -> read items (start (first + 1))
      in
      read [] (start 0)

let parse source = Result.map fst (with_trivia source)
let model_of t source = of_tokens t source Parser.Incremental.model
let expression_of t source = of_tokens t source Parser.Incremental.expression
let expression source = expression_of (Tokens.read source) source
