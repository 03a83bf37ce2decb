open Scc_base
open Parser

type token = { token : Parser.token; start : int; stop : int; after_fault : bool }

type t = {
  file : string;
  tokens : token array;
  trivia : Trivia.t list;
  faults : Diag.t list;
  opening : int array;
  unclosed : bool array;
  restart : bool array;
}

let max_faults = 20
let max_nesting = 1_000
let max_depth = 10_000

(* {1 From text to lexemes} *)

type reading = {
  mutable read : token list;  (* in reverse *)
  mutable seen : Trivia.t list;  (* in reverse *)
  mutable found : Diag.t list;  (* in reverse *)
  mutable count : int;  (* of [found] *)
  mutable fresh : bool;  (* nothing but spaces so far on this line *)
  mutable newlines : int;  (* since the last token or comment *)
  mutable fault_before : bool;  (* since the last token *)
}

let report r d =
  r.found <- d :: r.found;
  r.count <- r.count + 1

let unix_line_ends text =
  let n = String.length text in
  let b = Buffer.create n in
  String.iteri
    (fun i c ->
       if c <> '\r' then Buffer.add_char b c
       else if i + 1 >= n || text.[i + 1] <> '\n' then Buffer.add_char b '\n')
    text;
  Buffer.contents b

(* Line ends as "\n"; a line comment without the spaces at its end. *)
let clean_comment kind text =
  match kind with
  | Trivia.Line ->
    let rec stop i = if i > 0 && (text.[i - 1] = ' ' || text.[i - 1] = '\t') then stop (i - 1) else i in
    String.sub text 0 (stop (String.length text))
  | Block | Blank -> if String.contains text '\r' then unix_line_ends text else text

let comment r source kind start stop =
  let text = clean_comment kind (String.sub (Source.text source) start (stop - start)) in
  r.seen <- { Trivia.kind; text; start; stop; own_line = r.fresh } :: r.seen

(* The empty lines before what starts at [start], if any. *)
let blank r start =
  if r.newlines > 1 then
    r.seen <- { Trivia.kind = Blank; text = ""; start = start - 1; stop = start; own_line = true } :: r.seen;
  r.newlines <- 0

let push r token start stop =
  blank r start;
  r.read <- { token; start; stop; after_fault = r.fault_before } :: r.read;
  r.fresh <- false;
  r.fault_before <- false

let is_slash = function { token = SLASH; _ } :: _ -> true | _ -> false

let push_checked r file token start stop =
  (match token with
   | NUMBER q when Q.sign q = 0 && is_slash r.read ->
     report r
       (Diag.error Code.zero_denominator (Span.make ~file ~start ~stop) "this is a division by zero")
   | _ -> ());
  push r token start stop

let lex source =
  let r =
    { read = []; seen = []; found = []; count = 0; fresh = true; newlines = 0; fault_before = false }
  in
  let file = Source.name source in
  let lexbuf = Lexing.from_string (Source.text source) in
  let rec loop () =
    let lexeme = Lexer.next lexbuf in
    let start = (Lexing.lexeme_start_p lexbuf).pos_cnum and stop = (Lexing.lexeme_end_p lexbuf).pos_cnum in
    match lexeme with
    | Token EOF -> push r EOF stop stop
    | _ when r.count >= max_faults -> push r EOF start start
    | Token t ->
      push_checked r file t start stop;
      loop ()
    | Newline ->
      r.fresh <- true;
      r.newlines <- r.newlines + 1;
      loop ()
    | Line_comment -> note Trivia.Line start stop
    | Block_comment -> note Trivia.Block start stop
    | Fault f ->
      let stop' = if f.opening then min stop (start + 2) else stop in
      report r (Diag.error ?hint:f.hint f.code (Span.make ~file ~start ~stop:stop') "%s" f.message);
      r.fault_before <- true;
      Option.iter (fun t -> push r t start stop) f.instead;
      r.fault_before <- true;
      r.fresh <- false;
      loop ()
  and note kind start stop =
    blank r start;
    comment r source kind start stop;
    r.fresh <- false;
    loop ()
  in
  loop ();
  r

(* {1 Brackets}

   One pass keeps a stack of open brackets. A word that can only begin a declaration closes, in effect, every
   bracket but the braces of [for]: whatever is open there was left open by mistake. *)

type bracket =
  | Round
  | Square
  | Curly
  | Range  (* of a parameter: `(` or `[`, and either closes it *)

type level = {
  index : int;  (* of the opening bracket; -1 for the whole text *)
  bracket : bracket;
  loop : bool;  (* the body of a [for] *)
  mutable operators : int;  (* at this level, since the last declaration *)
  mutable deepest : int;  (* of the bracketed things among them *)
}

(* What adds a node above its operands without a bracket of its own. *)
let nests = function
  | PLUS | MINUS | STAR | SLASH | MOD | AND | OR | NOT | IMPLIES | LEADS_TO | IF | FORALL | EXISTS |
    POSSIBLY | ALWAYS
  | EVENTUALLY | AX | EX | AF | EF | AG | EG | DOT | SCALED -> true
  | _ -> false

(* The words that are names as well, be it only where no operator can stand. *)
let can_be_name = function
  | NAME _ | LETTER _ | MOD | HULL | AS | WHERE | A | E | U | AF | AG | AX | EF | EG | EX | BOND | MASS |
    EVENT | DYNAMICS | COLLISIONS
  | BINDING | BONDS | BLOCKED | RESOLUTION | ROUND | SNAP | GRID | WELD | ORIENT | MERGE | UNION
  | DECOMPOSE -> true
  | _ -> false

let begins_declaration tokens i =
  match tokens.(i).token with
  | MODEL | IMPORT | PARAM | TIMESTEP | SPLIT_STEP | SHAPE | COMPOUND | PROCESS | FIXED | FOR | NETWORK | MOTION
  | LET | CHECK -> true
  | BEHAVIOUR -> (match tokens.(i + 1).token with LPAREN -> false | _ -> true)
  | _ -> false

let ended tokens i =
  i = 0 || (match tokens.(i - 1).token with
      | RBRACKET | RBRACE | RPAREN | GT | NAME _ | LETTER _ | MOD | HULL | AS | WHERE | ONLY | STEADY | A
      | E | U | AF | AG | AX | EF | EG | EX
      | EVENT | NUMBER _ | NIL | INERTIAL | LOCAL -> true
      | _ -> false)

(* [bond] is also a name: it begins a declaration when nothing before it asks for a name. *)
let begins_bond tokens i =
  match (tokens.(i).token, tokens.(i + 1).token) with BOND, LT -> ended tokens i | _ -> false

(* So are the words of the settings of rigid motion, which are followed by a name or a number. *)
let begins_setting tokens i =
  let ended () =
    ended tokens i || (match tokens.(i - 1).token with TRUE | FALSE -> true | _ -> false)
  in
  match (tokens.(i).token, tokens.(i + 1).token) with
  | (DYNAMICS | COLLISIONS | BINDING | BONDS | BLOCKED), NAME _ | ROUND, (NAME _ | VELOCITY) -> ended ()
  | RESOLUTION, (NUMBER _ | NAME _ | LPAREN) -> ended ()
  | _ -> false

type structure = {
  tokens : token array;
  opening : int array;
  unclosed : bool array;
  restart : bool array;
  mutable stack : level list;  (* never empty: the whole text is last *)
  mutable nesting : int;
  mutable in_for : bool;  (* the last declaration to begin is a [for] whose `{` is to come *)
  mutable too_deep : (int * string * string option) option;
}

let top s = match s.stack with l :: _ -> l | [] -> Bug.fail __POS__ "no level"

let refuse ?hint s i what = if Option.is_none s.too_deep then s.too_deep <- Some (i, what, hint)

let depth level = level.operators + level.deepest

let hint_of = function
  | PLUS | STAR | AND | OR -> Some "brackets around parts of a chain make it less deep: `(a + b) + (c + d)`"
  | _ -> None

let check_depth s i =
  if depth (top s) > max_depth then
    refuse s i ?hint:(hint_of s.tokens.(i).token)
      (Printf.sprintf
         "this declaration goes more than %d operators and prefixes deep: a chain is as deep as it is long"
         max_depth)

let open_bracket s i bracket =
  let loop = s.in_for && (match bracket with Curly -> true | Round | Square | Range -> false) in
  if loop then s.in_for <- false;
  s.unclosed.(i) <- true;
  s.stack <- { index = i; bracket; loop; operators = 0; deepest = 0 } :: s.stack;
  s.nesting <- s.nesting + 1;
  if s.nesting > max_nesting then
    refuse s i (Printf.sprintf "brackets are nested too deeply (the limit is %d)" max_nesting)

let pop s =
  let inner = top s in
  s.stack <- (match s.stack with _ :: rest -> rest | [] -> []);
  s.nesting <- s.nesting - 1;
  let outer = top s in
  outer.deepest <- max outer.deepest (depth inner + 1)

let same_bracket a b =
  match (a, b) with
  | Round, Round | Square, Square | Curly, Curly | Range, (Round | Square) -> true
  | (Round | Square | Curly | Range), _ -> false

let close_bracket s i bracket =
  let l = top s in
  if l.index >= 0 && same_bracket l.bracket bracket then begin
    s.opening.(i) <- l.index;
    s.unclosed.(l.index) <- false;
    (match (bracket, s.tokens.(i + 1).token) with
     | Square, COLON -> s.tokens.(l.index) <- { (s.tokens.(l.index)) with token = LABEL_BRACKET }
     | _ -> ());
    pop s;
    check_depth s i
  end

let rec leave_brackets s = if (top s).index >= 0 && not (top s).loop then (pop s; leave_brackets s)

let declare s i =
  leave_brackets s;
  let l = top s in
  l.operators <- 0;
  l.deepest <- 0;
  s.restart.(i) <- true;
  s.in_for <- (match s.tokens.(i).token with FOR -> true | _ -> false)

let opens_range s i =
  i >= 3
  && match (s.tokens.(i - 3).token, s.tokens.(i - 1).token) with PARAM, IN -> true | _ -> false

let visit s i =
  match s.tokens.(i).token with
  | (LPAREN | LBRACKET) when opens_range s i -> open_bracket s i Range
  | LPAREN -> open_bracket s i Round
  | LBRACKET -> open_bracket s i Square
  | LBRACE -> open_bracket s i Curly
  | RPAREN -> close_bracket s i Round
  | RBRACKET -> close_bracket s i Square
  | RBRACE -> close_bracket s i Curly
  | _ when begins_declaration s.tokens i -> declare s i
  | PART | GLUE ->
    let l = top s in
    l.operators <- 0;
    l.deepest <- 0
  | t ->
    let begins = begins_bond s.tokens i || begins_setting s.tokens i in
    if begins && ((top s).index < 0 || (top s).loop) then s.restart.(i) <- true;
    if nests t then begin
      let l = top s in
      l.operators <- l.operators + 1;
      check_depth s i
    end

let structure tokens =
  let n = Array.length tokens in
  let whole = { index = -1; bracket = Curly; loop = false; operators = 0; deepest = 0 } in
  let s =
    {
      tokens;
      opening = Array.make n (-1);
      unclosed = Array.make n false;
      restart = Array.make n false;
      stack = [ whole ];
      nesting = 0;
      in_for = false;
      too_deep = None;
    }
  in
  (* The last token is [EOF]: [i + 1] is an index wherever a token looks ahead. *)
  for i = 0 to n - 2 do visit s i done;
  s

let not_text file fault =
  let at, size, message =
    match fault with
    | Utf8.Invalid i -> (i, 1, "this is not UTF-8 text")
    | Control { at; size; code } ->
      (at, size, Printf.sprintf "this is not text: it holds the control character U+%04X" code)
  in
  Diag.error Code.not_text (Span.make ~file ~start:at ~stop:(at + size)) "%s" message

let is_word text = List.exists (fun (word, _) -> String.equal word text) Lexer.words

let read ?(rewrite = fun tokens -> (tokens, [])) source =
  let file = Source.name source and text = Source.text source in
  let read, trivia, faults =
    match Utf8.check text with
    | None -> let r = lex source in (r.read, r.seen, r.found)
    | Some fault ->
      ([ { token = EOF; start = 0; stop = 0; after_fault = true } ], [], [ not_text file fault ])
  in
  let tokens, misplaced = rewrite (Array.of_list (List.rev read)) in
  let s = structure tokens in
  let deep =
    match s.too_deep with
    | None -> []
    | Some (i, what, hint) ->
      let { start; stop; _ } : token = s.tokens.(i) in
      [ Diag.error Code.too_deep (Span.make ~file ~start ~stop) ?hint "%s" what ]
  in
  {
    file;
    tokens = s.tokens;
    trivia = List.rev trivia;
    faults = List.rev_append faults (misplaced @ deep);
    opening = s.opening;
    unclosed = s.unclosed;
    restart = s.restart;
  }

let hopeless (t : t) =
  List.exists
    (fun (d : Diag.t) ->
       String.equal d.code (Code.too_deep :> string) || String.equal d.code (Code.not_text :> string))
    t.faults

let span (t : t) i = Span.make ~file:t.file ~start:t.tokens.(i).start ~stop:t.tokens.(i).stop
