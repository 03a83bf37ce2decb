open Scc_base

type t = { source : Source.t; text : string; place : int -> int }
type 'a read = t -> ('a, Diag.t list) result

let file e = Source.name e.source
let span e = Span.make ~file:(file e) ~start:(e.place 0) ~stop:(e.place (String.length e.text))

(* {1 The tokens of a piece, at their places} *)

let placed_span e (s : Span.t) = Span.make ~file:(file e) ~start:(e.place s.start) ~stop:(e.place s.stop)

let placed_fault e (d : Diag.t) =
  { d with span = placed_span e d.span; notes = List.map (fun (s, n) -> (placed_span e s, n)) d.notes }

let tokens e : Tokens.t =
  let t = Tokens.read (Source.make ~name:(file e) e.text) in
  let placed (token : Tokens.token) = { token with start = e.place token.start; stop = e.place token.stop } in
  (* Of a text that is not to be parsed, the faults alone are of use. *)
  let tokens = if Tokens.hopeless t then t.tokens else Array.map placed t.tokens in
  { t with tokens; faults = List.map (placed_fault e) t.faults }

let expression e = Parse.expression_of (tokens e) e.source

(* {1 In a context}

   The grammar has no entrance for a feature alone. Between the tokens of a declaration that holds one and
   nothing else, a piece is a feature exactly if all of it is that declaration, with the feature in its place:
   text that closes the declaration and begins another one makes it two. *)

let between before (t : Tokens.t) after : Tokens.t =
  let n = Array.length t.tokens - 1 and shift = List.length before in
  let added at token : Tokens.token = { token; start = at; stop = at; after_fault = false } in
  let first = t.tokens.(0).start and last = t.tokens.(n).stop in
  let before = Array.of_list (List.map (added first) before) in
  let after = Array.of_list (List.map (added last) (after @ [ Parser.EOF ])) in
  let around none own = Array.concat [ Array.map (fun _ -> none) before; own; Array.map (fun _ -> none) after ] in
  let opening = Array.map (fun i -> if i < 0 then i else i + shift) (Array.sub t.opening 0 n) in
  {
    t with
    tokens = Array.concat [ before; Array.sub t.tokens 0 n; after ];
    opening = around (-1) opening;
    unclosed = around false (Array.sub t.unclosed 0 n);
    restart = around false (Array.make n false);
  }

let expected e what = Error [ Diag.error Code.syntax (span e) "%s is expected here" what ]

let in_context before after what found e =
  let t = tokens e in
  match t.faults with
  | _ :: _ -> Error t.faults
  | [] -> (
      match Parse.model_of (between before t after) e.source with
      | Ok [ { it = (item : Ast.item_kind); _ } ] ->
        Option.fold ~none:(expected e what) ~some:Result.ok (found item)
      | Ok _ | Error _ -> expected e what)

let some : Parser.token = NAME "_"

let name e =
  in_context [ MODEL ] [] "a name, such as `cube`, that is no word of the language,"
    (function Ast.Model n -> Some n | _ -> None)
    e

let word e = in_context [ DYNAMICS ] [] "one word" (function Ast.Dynamics n -> Some n | _ -> None) e

let rounded e =
  let one = function { Ast.it = Ast.Number q; _ } -> Q.equal q Q.one | _ -> false in
  in_context [ ROUND ] [ NUMBER Q.one ] "`orientation` or `velocity`"
    (function Ast.Round (n, e) when one e -> Some n | _ -> None)
    e

let path e =
  in_context [ MOTION ] [ EQ; INERTIAL ] "a name, such as `p`, `c[i, j]` or `c[i].left`,"
    (function Ast.Motion (Some p, { it = Inertial; _ }) -> Some p | _ -> None)
    e

let segment e =
  match path e with
  | Ok { it = [ s ]; _ } -> Ok s
  | Ok _ | Error _ -> expected e "a name, perhaps with indices, such as `p` or `c[i, j]`,"

let a_feature = "a feature, such as `top`, `q.left.top` or `[a, b]`,"

let feature e =
  in_context [ BOND; LT; some; COMMA; LBRACE ] [ COMMA; some; RBRACE; GT ] a_feature
    (function Ast.Bond b -> Some b.first | _ -> None)
    e

let member ~only e =
  let word : Parser.token list = if only then [ ONLY ] else [] in
  in_context
    ([ Parser.BEHAVIOUR; some; EQ; LT; some; COMMA; LBRACE ] @ word)
    [ RBRACE; GT; DOT; NIL ] a_feature
    (function
      | Ast.Behaviour (_, None, { it = Open ({ features = [ m ]; _ }, { it = Nil; _ }); _ }, [])
        when Bool.equal m.only only -> Some m
      | _ -> None)
    e

let template e =
  in_context [ SHAPE; some; EQ ] [] "the name of a shape, such as `Cube`, `m.Cube` or `Brick(1, 2)`,"
    (function Ast.Shape (_, { it = Template r; _ }, []) -> Some r | _ -> None)
    e

let behaviour e =
  in_context [ BEHAVIOUR; some; EQ ] [] "the name of a behaviour, such as `K`, `m.K(2)` or `K[i]`,"
    (function Ast.Behaviour (_, None, { it = Name r; _ }, []) -> Some r | _ -> None)
    e

let head e =
  in_context [ BEHAVIOUR ] [ EQ; NIL ] "the name of a behaviour, such as `K` or `K[i, 0]`,"
    (function Ast.Behaviour (h, None, { it = Nil; _ }, []) -> Some h | _ -> None)
    e
