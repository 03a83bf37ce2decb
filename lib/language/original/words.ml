open Scc_base
open Scc_syntax
open Parser

type state = {
  tokens : Tokens.token array;
  file : string;
  mutable written : Tokens.token list;  (* in reverse *)
  mutable faults : Diag.t list;
  mutable chain : bool;  (* in a process or fixed body *)
  mutable square : int;  (* square brackets open in this declaration *)
}

let token s i = s.tokens.(Int.min i (Array.length s.tokens - 1)).token
let span s i j = Span.make ~file:s.file ~start:s.tokens.(i).start ~stop:s.tokens.(j).stop
let fault ?hint s code i j text = s.faults <- Diag.error ?hint code (span s i j) "%s" text :: s.faults
let put s (t : Tokens.token) = s.written <- t :: s.written
let copy s i = put s s.tokens.(i)

let copy_all s i j =
  for k = i to j - 1 do copy s k done

(* A word that nobody wrote, in the place of the token [i] that comes next. *)
let add s i token = put s { (s.tokens.(i)) with token; after_fault = false }

(* A word in place of the tokens from [i] to [j]. *)
let replace s i j token =
  put s { Tokens.token; start = s.tokens.(i).start; stop = s.tokens.(j).stop; after_fault = false }

let ends_all = function
  | EOF | MODEL | PARAM | TIMESTEP | SPLIT_STEP | SHAPE | COMPOUND | PROCESS | FIXED | NETWORK | MOTION |
    CHECK | IMPORT
    -> true
  | _ -> false

(* A region of more tokens than this is not looked for: so reading takes a time that is linear in the text. *)
let longest = 5_000

(* The first token from [i] on, outside of brackets that open there, for which this holds. *)
let find s first holds =
  let rec go i depth =
    let t = token s i in
    if ends_all t || i - first > longest then None
    else if depth = 0 && holds t then Some i
    else
      match t with
      | LPAREN | LBRACKET | LBRACE -> go (i + 1) (depth + 1)
      | RPAREN | RBRACKET | RBRACE -> if depth = 0 then None else go (i + 1) (depth - 1)
      | _ -> go (i + 1) depth
  in
  go first 0

(* Where a region ends that begins at [i], if this comes before anything that is in no region. *)
let end_of_region s i ends =
  match find s i (fun t -> ends t || (match t with COMMA | LT | LE | GE | GT | EQ -> true | _ -> false)) with
  | Some stop when stop > i && ends (token s stop) -> Some stop
  | Some _ | None -> None

let is_gt = function GT -> true | _ -> false
let is_comma = function COMMA -> true | _ -> false
let is_closing = function RPAREN -> true | _ -> false

(* The commas, or other tokens, between [i] and [j] outside of brackets, in order. *)
let all s i j holds =
  let rec go found i =
    match find s i holds with
    | Some k when k < j -> go (k :: found) (k + 1)
    | Some _ | None -> List.rev found
  in
  go [] i

let hold_region s i j =
  add s i (NAME Tree.surface);
  add s i LBRACKET;
  copy_all s i j;
  add s j RBRACKET

(* The region between [i] and [j], as a set of one feature. *)
let surface s i j =
  match token s i with
  | LBRACE ->
    fault s Code.bad_region i (j - 1) "features in braces are of the refined calculus"
      ~hint:"a region is written without braces, as in `<dock, top + left>`";
    copy_all s i j
  | _ ->
    add s i LBRACE;
    hold_region s i j;
    add s j RBRACE

(* The regions of which the tokens between [i] and [j] are the intersection. *)
let common s i j between =
  let stars = all s i j (function STAR -> true | _ -> false) in
  let others = all s i j (function PLUS | MINUS -> true | _ -> false) in
  match (stars, others) with
  | [ k ], [] when k > i && k < j - 1 ->
    hold_region s i k;
    add s k between;
    hold_region s (k + 1) j
  | _ ->
    fault s Code.not_common i (Int.max i (j - 1)) "this is not the common surface of two regions"
      ~hint:"write `X * Y`, where X is on the one body and Y on the other";
    add s i (NAME Tree.surface);
    add s j between;
    add s j (NAME Tree.surface)

let is_name t = Tokens.can_be_name t || (match t with ONLY | STEADY | PUSH | ABSORB -> true | _ -> false)

(* [<a,], [<~a,], after the mark at [i]: where the region begins. *)
let after_name s i =
  match (token s i, token s (i + 1), token s (i + 2)) with
  | TILDE, n, COMMA when is_name n -> Some (i + 3)
  | BARRED _, COMMA, _ -> Some (i + 2)
  | n, COMMA, _ when is_name n -> Some (i + 2)
  | _ -> None

let ends_operand = function
  | NUMBER _ | RPAREN | RBRACKET | TRUE | FALSE -> true
  | t -> Tokens.can_be_name t

let before s i = if i = 0 then EOF else token s (i - 1)

let tuple s i =
  match find s (i + 1) is_gt with
  | None -> None
  | Some stop -> (
      match all s (i + 1) stop is_comma with
      | [ a; b; c ] ->
        let bracketed from upto =
          add s from LPAREN;
          copy_all s from upto;
          add s upto RPAREN
        in
        copy_all s (i + 1) a;
        add s a MASS;
        bracketed (a + 1) b;
        add s c VELOCITY;
        bracketed (c + 1) stop;
        add s b AT;
        add s b TRANSLATE;
        bracketed (b + 1) c;
        Some (stop + 1)
      | _ ->
        fault s Code.bad_arity i stop "a basic shape is a tuple of four: <solid, mass, place, velocity>";
        copy_all s (i + 1) (match all s (i + 1) stop is_comma with comma :: _ -> comma | [] -> stop);
        Some (stop + 1))

let channel s i =
  match after_name s (i + 1) with
  | None -> None
  | Some first -> (
      match end_of_region s first is_gt with
      | Some stop ->
        copy_all s i first;
        surface s first stop;
        copy s stop;
        Some (stop + 1)
      | None -> None)

let bond s i =
  match after_name s (i + 1) with
  | None -> None
  | Some first -> (
      match end_of_region s first is_gt with
      | Some stop ->
        copy_all s i first;
        add s first LBRACE;
        common s first stop COMMA;
        add s stop RBRACE;
        copy s stop;
        Some (stop + 1)
      | None -> None)

(* These words are names, or begin an atom of formulas, elsewhere. *)
let declares s i =
  match (token s i, token s (i + 1)) with
  | BOND, LT -> Option.is_some (after_name s (i + 2))
  | BEHAVIOUR, LPAREN -> false
  | BEHAVIOUR, _ -> true
  | _ -> false

(* What `<` begins: in a chain, outside of the behaviours, a basic shape or a bond; elsewhere a channel, unless
   what stands before it makes it a comparison. *)
let angle s i =
  let outside = s.chain && s.square = 0 in
  match before s i with
  | BOND when declares s (i - 1) -> bond s i
  | EQ | COLON | GT | LPAREN when outside -> tuple s i
  | COLON -> tuple s i
  | IMPORT -> None
  | _ when outside -> bond s i
  | t when ends_operand t -> None
  | _ -> channel s i

let weak s i =
  match (token s (i + 1), after_name s (i + 2)) with
  | LPAREN, Some first -> (
      match end_of_region s first is_closing with
      | Some stop ->
        copy_all s i first;
        surface s first stop;
        copy s stop;
        Some (stop + 1)
      | None -> None)
  | _ -> None

let glue s i =
  let stop =
    match find s (i + 1) (function GLUE -> true | _ -> false) with
    | Some stop -> Some stop
    | None ->
      let rec closing j depth =
        match token s j with
        | LPAREN | LBRACKET | LBRACE -> closing (j + 1) (depth + 1)
        | RBRACE when depth = 0 -> Some j
        | RPAREN | RBRACKET | RBRACE -> closing (j + 1) (depth - 1)
        | t -> if ends_all t || j - i > longest then None else closing (j + 1) depth
      in
      closing (i + 1) 0
  in
  match stop with
  | Some stop when stop > i + 1 ->
    copy s i;
    common s (i + 1) stop TILDE;
    Some stop
  | Some _ | None -> None

(* [region R on S =], [curved inscribed]. *)
let declaration s i =
  let name t =
    match t with
    | NAME n | LETTER n -> Some n
    | t when is_name t -> Option.map fst (List.find_opt (fun (_, word) -> word == t) Lexer.words)
    | _ -> None
  in
  match (token s i, name (token s (i + 1)), token s (i + 2), name (token s (i + 3)), token s (i + 4)) with
  | NAME "region", Some r, ON, Some shape, EQ ->
    replace s i i LET;
    replace s (i + 1) (i + 3) (NAME (Tree.keyword (`Region (r, shape))));
    Some (i + 4)
  | NAME "curved", Some (("inscribed" | "circumscribed") as word), _, _, _ ->
    replace s i i LET;
    replace s (i + 1) (i + 1) (NAME (Tree.keyword (`Curved word)));
    add s (i + 2) EQ;
    Some (i + 2)
  | _ -> None

let note s i =
  match token s i with
  | (BOND | BEHAVIOUR) when not (declares s i) -> ()
  | PROCESS | FIXED -> s.chain <- true; s.square <- 0
  | LBRACKET -> s.square <- s.square + 1
  | RBRACKET -> s.square <- Int.max 0 (s.square - 1)
  | BOND | BEHAVIOUR | LET | FOR | SHAPE | COMPOUND | MOTION | NETWORK | CHECK | PARAM -> s.chain <- false
  | _ -> ()

let rewrite ~file (tokens : Tokens.token array) =
  let s = { tokens; file; written = []; faults = []; chain = false; square = 0 } in
  let last = Array.length tokens - 1 in
  let rec go i =
    if i >= last then copy s last
    else begin
      let t = token s i in
      note s i;
      let next =
        match t with
        | LT -> angle s i
        | OMEGA -> weak s i
        | GLUE -> glue s i
        | NAME _ -> declaration s i
        | _ -> None
      in
      match next with
      | Some next -> go next
      | None ->
        copy s i;
        go (i + 1)
    end
  in
  go 0;
  (Array.of_list (List.rev s.written), List.rev s.faults)
