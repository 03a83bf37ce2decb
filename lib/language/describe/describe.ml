open Scc_base
open Scc_syntax

type t = { at : Span.t; kind : string; name : string; text : string; declared : Span.t option }

let text fmt = Printf.sprintf fmt

(* {1 Texts for people} *)

let longest = 400

let clipped s = if String.length s <= longest then s else String.sub s 0 (Utf8.boundary s longest) ^ " …"

let source_of source (d : Declared.t) =
  match d.shown with
  | None -> []
  | Some { start; stop; _ } -> [ clipped (String.sub (Source.text source) start (stop - start)) ]

let lines = String.concat "\n"
let of_word (e : Vocabulary.entry) = text "`%s`: %s\n(specs/language.md, %s)" e.word e.meaning e.section

(* Names, each once, in order; the first of many. *)
let some_of names =
  let rec take kept n = function
    | [] -> List.rev kept
    | name :: rest when List.mem name kept -> take kept n rest
    | _ :: _ when n = 0 -> List.rev ("…" :: kept)
    | name :: rest -> take (name :: kept) (n - 1) rest
  in
  String.concat ", " (take [] 12 names)

let times = function 1 -> "once" | 2 -> "twice" | n -> text "%d times" n

let of_channel uses name =
  let all = Uses.channel uses name in
  let line how words =
    match List.filter (fun (u : Scope.channel_use) -> u.how = how) all with
    | [] -> []
    | found ->
      let owners = List.filter (fun o -> o <> "") (List.map (fun (u : Scope.channel_use) -> u.owner) found) in
      let where = match owners with [] -> "" | _ :: _ -> " in " ^ some_of owners in
      [ text "%s %s%s" words (times (List.length found)) where ]
  in
  let told =
    line As_name (text "open as `%s`" name)
    @ line As_co_name (text "open as its co-name `~%s`" name)
    @ line Weak "in weak splits" @ line Strong "in strong splits" @ line Bond "in bonds from the start"
    @ line Passed "as an argument" @ line Asked "asked about"
  in
  lines (text "channel `%s`" name :: told)

(* {1 Modules} *)

type read = library:bool -> string -> string option

let read_module (read : read) (i : Ast.import) =
  Option.map (Source.make ~name:i.from.it) (read ~library:i.library i.from.it)

let from (i : Ast.import) = if i.library then text "<%s>" i.from.it else text "\"%s\"" i.from.it

let exported (all : Declared.all) name =
  List.concat_map (fun table -> Declared.find table name) [ all.templates; all.behaviours; all.values ]

(* The kind and the text of what a module declares. *)
let of_exported read (i : Ast.import) name =
  let unread = ("imported", text "`%s` of %s" name (from i)) in
  match read_module read i with
  | None -> unread
  | Some source -> (
      match exported (Declared.of_model (Scc_notation.Notation.readable source)) name with
      | [] -> ("imported", text "`%s`: %s declares nothing of this name" name (from i))
      | d :: _ -> (Declared.kind d.kind, lines (text "%s, from %s" d.what (from i) :: source_of source d)))

let names_of read (i : Ast.import) =
  match read_module read i with
  | None -> []
  | Some source ->
    let declares (item : Ast.item) =
      match item.it with
      | Shape (h, _, _) | Compound (h, _, _, _) | Decomposed (h, _, _, _) | Behaviour (h, _, _, _) ->
        [ Printer.head h ]
      | Param (n, _) | Param_in (n, _, _) | Let (n, _) -> [ n.it ]
      | _ -> []
    in
    [ "it declares " ^ some_of (List.concat_map declares (Scc_notation.Notation.readable source)) ]

(* {1 Names} *)

let of_declared read source (at : Span.t) (ds : Declared.t list) =
  let here (d : Declared.t) = Span.equal d.name.at at in
  match (List.find_opt here ds, ds) with
  | None, [] -> None
  | Some d, _ | None, d :: _ ->
    let kind, told =
      match d.source with
      | Some (i, "") -> (Declared.kind d.kind, lines (d.what :: names_of read i))
      | Some (i, name) -> of_exported read i name
      | None ->
        let others =
          match List.length ds with 1 -> [] | n -> [ text "(one of %d declarations of this name)" n ]
        in
        (Declared.kind d.kind, lines ((d.what :: source_of source d) @ others))
    in
    Some (kind, told, Some d.name.at)

let of_meaning read source uses (u : Scope.use) =
  let name = u.name.it in
  match Lazy.force u.meaning with
  | Declared ds | Alike ds -> of_declared read source u.name.at ds
  | Channel -> Some ("channel", of_channel uses name, None)
  | Word e -> Some (e.kind, of_word e, None)
  | Of_module { source = Some (i, _); name = at; _ } ->
    let kind, told = of_exported read i name in
    Some (kind, told, Some at.at)
  | Feature -> Some ("feature", text "`%s`: a face or a vertex, of the solid that is meant there" name, None)
  | Of_module _ | Unknown -> None

(* {1 Words} *)

let keyword source (token : Tokens.token) =
  let word =
    match token.token with
    | OMEGA -> "omega"
    | RHO -> "rho"
    | EPS -> "eps"
    | _ -> String.sub (Source.text source) token.start (token.stop - token.start)
  in
  Option.map (fun (e : Vocabulary.entry) -> (e.word, e)) (Vocabulary.find Word word)

(* What is declared in what cannot be read: a name after the word that a declaration begins with. *)
let unread (t : Tokens.t) (name : string) =
  let count = Array.length t.tokens - 1 in
  let rec last i = if i >= count || t.restart.(i) then i - 1 else last (i + 1) in
  let declares i : Declared.kind option =
    match (t.tokens.(i).token, t.tokens.(i + 1).token) with
    | (PARAM | LET | FOR | SHAPE | COMPOUND | BEHAVIOUR | PROCESS | FIXED | CHECK), NAME n
      when t.restart.(i) && String.equal n name -> (
        match t.tokens.(i).token with
        | PARAM -> Some Parameter
        | LET -> Some Value
        | FOR -> Some Index
        | SHAPE -> Some Shape
        | COMPOUND -> Some Compound
        | BEHAVIOUR -> Some Behaviour
        | PROCESS -> Some Process
        | FIXED -> Some Fixed
        | _ -> Some Check)
    | _ -> None
  in
  let one i =
    let declared kind =
      let at = Tokens.span t (i + 1) and shown = Span.merge (Tokens.span t i) (Tokens.span t (last (i + 1))) in
      let what = text "%s `%s`, of which the declaration cannot be read yet" (Declared.kind kind) name in
      Declared.make kind { it = name; at } ~shown what
    in
    Option.map declared (declares i)
  in
  List.filter_map one (List.init count Fun.id)

(* A name of which only the spelling tells: it is in a declaration that cannot be read, or declared in one. *)
let by_spelling (t : Tokens.t) (uses : Uses.t) i (name : Ast.name) =
  let all = uses.all in
  let qualified () =
    let before k = if i < k then Parser.EOF else t.tokens.(i - k).token in
    match (before 2, before 1) with
    | NAME q, DOT -> (
        match Declared.find all.modules q with [] -> None | m :: _ -> Some (Scope.Of_module m))
    | _ -> None
  in
  let tables = [ all.bodies; all.behaviours; all.templates; all.values; all.modules; all.features ] in
  let words = [ Vocabulary.Atom; Function; Solid; Event; Setting; Law; Measure ] in
  let declared = List.map (fun table -> Scope.among table name.it) tables in
  let unread () = match unread t name.it with [] -> None | found -> Some (Scope.Declared found) in
  let channel () = match Uses.channel uses name.it with [] -> None | _ :: _ -> Some Scope.Channel in
  let word category () = Scope.word category name.it in
  let meaning = Scope.first ((qualified :: declared) @ [ unread; channel ] @ List.map word words) in
  { Scope.name; meaning = Lazy.from_val meaning }

(* {1 At an offset} *)

let at_token read source (t : Tokens.t) uses i =
  let token = t.tokens.(i) in
  let at = Span.make ~file:(Source.name source) ~start:token.start ~stop:token.stop in
  let found name (kind, text, declared) = Some { at; kind; name; text; declared } in
  let word () = Option.bind (keyword source token) (fun (w, e) -> found w (e.kind, of_word e, None)) in
  let meaning = of_meaning read source uses in
  let spelt it =
    match meaning (by_spelling t uses i { it; at }) with
    | Some told -> found it told
    | None -> found it ("name", text "`%s`: there is no declaration of this name" it, None)
  in
  match (Uses.at uses token.start, token.token) with
  | Some u, spelling -> (
      match (meaning u, spelling) with
      | Some told, _ -> found u.name.it told
      | None, (NAME it | BARRED it) -> spelt it
      | None, _ -> word ())
  | None, (NAME it | BARRED it) -> spelt it
  | None, _ -> word ()

let at ~read_module:read (r : Reading.t) offset =
  let tokens = Lazy.force r.tokens in
  let one i = at_token read r.source tokens (Lazy.force r.uses) i in
  List.find_map one (Reading.tokens_at tokens offset)

let find ~read_module source = at ~read_module (Reading.make source)
