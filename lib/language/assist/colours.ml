open Scc_syntax
open Scc_describe

type kind =
  | Keyword
  | Comment
  | Text
  | Number
  | Module
  | Template
  | Behaviour
  | Body
  | Value
  | Argument
  | Feature
  | Channel
  | Function
  | Choice

type word = { start : int; stop : int; kind : kind; declares : bool }

let of_kind : Declared.kind -> kind option = function
  | Model | Check -> None
  | Parameter | Value -> Some Value
  | Index | Variable | Argument -> Some Argument
  | Shape | Compound -> Some Template
  | Part | Vertex | Face -> Some Feature
  | Behaviour -> Some Behaviour
  | Process | Fixed | Leaf -> Some Body
  | Module -> Some Module
  | Imported -> Some Template

let of_category : Vocabulary.category -> kind = function
  | Word | Measure | Event -> Keyword
  | Setting | Component | Law -> Choice
  | Solid -> Template
  | Function | Atom -> Function

let of_meaning : Scope.meaning -> kind option = function
  | Declared (d :: _) -> of_kind d.kind
  | Alike _ | Feature -> Some Feature
  | Channel -> Some Channel
  | Word e -> Some (of_category e.category)
  | Of_module _ -> Some Template
  | Declared [] | Unknown -> None

let declares (u : Scope.use) =
  match Lazy.force u.meaning with
  | Declared ds -> List.exists (fun (d : Declared.t) -> Int.equal d.name.at.start u.name.at.start) ds
  | _ -> false

let is_letter c = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')

let of_token source uses (t : Tokens.token) =
  let word kind declares = Some { start = t.start; stop = t.stop; kind; declares } in
  match (t.token, Uses.at uses t.start) with
  | EOF, _ -> None
  | STRING _, _ -> word Text false
  | NUMBER _, _ -> word Number false
  | _, Some u -> Option.bind (of_meaning (Lazy.force u.meaning)) (fun kind -> word kind (declares u))
  | (NAME _ | BARRED _), None -> None
  | (OMEGA | RHO | EPS), None -> word Keyword false
  | _, None -> if is_letter (Scc_base.Source.text source).[t.start] then word Keyword false else None

let of_text (r : Reading.t) =
  let tokens = Lazy.force r.tokens and uses = Lazy.force r.uses in
  let comment (c : Trivia.t) =
    if Trivia.is_comment c then Some { start = c.start; stop = c.stop; kind = Comment; declares = false } else None
  in
  let words = List.filter_map (of_token r.source uses) (Array.to_list tokens.tokens) in
  let before a b = Int.compare a.start b.start in
  List.merge before words (List.filter_map comment tokens.trivia)
