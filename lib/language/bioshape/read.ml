open Scc_base
open Scc_syntax
open Ast

let whole c = (Content.element c).Document.whole
let expr c key = Content.required c key Content.expression
let named c = Content.required c "name" Content.name

(* {1 Declarations} *)

let bounds c =
  let low = expr c "from" in
  let high = expr c "to" in
  { low; high; filter = Content.optional c "if" Content.expression }

let range c =
  let index = Content.required c "index" Content.name in
  { index; bounds = bounds c }

let ranges c = Content.many c [ "range" ] range
let where c = Content.many c [ "where" ] (fun c -> let n = named c in (n, expr c "value"))

let head c kind =
  let h = Content.required c "name" kind in
  match Content.optional c "parameters" Content.names with
  | None -> h
  | Some formals -> (
      match (h.places, h.formals) with
      | [], [] -> { h with formals }
      | _ ->
        Content.error (Content.reports c) Code.xml_unexpected (Content.element c).at
          "a name with something in brackets has no `parameters` as well";
        h)

let used c =
  let n = named c in
  (n, Content.optional c "as" Content.name)

let import c =
  let library = Content.has c "library" in
  let from =
    if library then
      Content.required c "library" Content.name
    else Content.required c "file" Content.line
  in
  match Content.many c [ "use" ] used with
  | [] -> Import { from; library; names = Qualified (Content.optional c "as" Content.name) }
  | chosen -> Import { from; library; names = Chosen chosen }

let parameter c =
  let n = named c in
  if Content.has c "value" then Param (n, expr c "value")
  else
    let limit included excluded =
      if Content.has c excluded then { value = expr c excluded; included = false }
      else { value = expr c included; included = true }
    in
    let low = limit "from" "above" in
    Param_in (n, low, limit "to" "below")

let timestep c =
  let e = expr c "value" in
  let paces = Content.choice [ ("local", Local); ("steady", Steady) ] in
  Timestep (e, Option.value ~default:Shared (Content.optional c "pace" paces))

let shape c =
  let h = head c Content.plain_head in
  let s = Terms.solid c in
  Shape (h, s, where c)

let part c =
  let part = named c in
  let part_solid = Terms.solid c in
  { part; part_solid; part_attributes = Terms.attributes c; part_span = whole c }

let glue c =
  let glue_first = Terms.feature c in
  { glue_first; glue_second = Terms.feature c; glue_span = whole c }

let compound c =
  let h = head c Content.plain_head in
  let parts = Content.many c [ "part" ] part in
  let glues = Content.many c [ "glue" ] glue in
  Compound (h, parts, glues, where c)

let rec drawn (s : solid) =
  match s.it with
  | Mesh _ | Faces _ -> true
  | Scaled (inner, _) -> drawn inner
  | Template _ | Hull _ -> false

let decomposed c =
  let h = head c Content.plain_head in
  let s = Terms.solid c in
  if not (drawn s) then Content.missing c "the solid of a `<decomposed>` is a `<mesh>` or an `<indexedFaceSet>`";
  let attributes = Terms.attributes c in
  Decomposed (h, s, attributes, where c)

let behaviour c =
  let h = head c Content.head in
  let on = Content.optional c "on" Content.template in
  let b = Terms.behaviour c in
  Behaviour (h, on, b, where c)

let leaf ~still c =
  let label = Content.optional c "label" Content.segment in
  let solid = Terms.solid c in
  let attributes = Terms.attributes c in
  let behaviour = Content.one c "behaviour" Terms.behaviour in
  if Option.is_none behaviour && not still then
    Content.missing c "the `<behaviour>` of this part of a process is missing";
  { label; solid; attributes; behaviour; leaf_span = whole c }

let bond c =
  let bond = Content.required c "channel" Content.name in
  let first = Terms.feature c in
  { bond; first; second = Terms.feature c; bond_span = whole c }

let chain ~still c =
  let s = Content.required c "name" Content.segment in
  let leaf c = Content.one c "leaf" (leaf ~still) in
  let no_leaf () = Content.missing c "a `<leaf>` is missing here: a shape with its behaviour" in
  let rec links acc =
    match Content.one c "bond" bond with
    | None -> List.rev acc
    | Some b -> (
        match leaf c with
        | Some l -> links ((b, l) :: acc)
        | None ->
          no_leaf ();
          List.rev acc)
  in
  match leaf c with
  | Some first -> Some (s, first, links [])
  | None ->
    no_leaf ();
    None

let process c = Option.map (fun (s, l, rest) -> Process (s, l, rest)) (chain ~still:false c)
let fixed c = Option.map (fun (s, l, rest) -> Fixed (s, l, rest)) (chain ~still:true c)

let network c = Network (Content.many c [ "member" ] (fun c -> Content.required c "name" Content.path))

let kick c =
  let velocity = expr c "velocity" in
  let spin = Content.optional c "spin" Content.expression in
  let weight = Content.optional c "weight" Content.expression in
  { over = ranges c; velocity; spin; weight }

let choose c =
  match Content.many c [ "kick" ] kick with
  | [] ->
    Content.missing c "a `<kick>` is missing here";
    []
  | kicks -> kicks

let law c =
  let found law = Some { it = law; at = whole c } in
  match Content.next c with
  | Some "inertial" -> Option.bind (Content.one c "inertial" ignore) (fun () -> found Inertial)
  | Some "velocity" ->
    let velocity c =
      let value = expr c "value" in
      { it = Expression (value, Content.optional c "spin" Content.expression); at = whole c }
    in
    Content.one c "velocity" velocity
  | Some "choose" -> Option.bind (Content.one c "choose" choose) (fun kicks -> found (Choose kicks))
  | Some _ | None ->
    Content.missing c "a law is missing here: `<inertial>`, `<velocity>` or `<choose>`";
    None

let motion c =
  let of_whom = Content.optional c "of" Content.path in
  Option.map (fun l -> Motion (of_whom, l)) (law c)

let setting make c = Some (make (Content.required c "value" Content.word))
let valued make c = Some (make (expr c "value"))
let always f c = Some (f c)

let round c =
  let n = Content.required c "of" Content.rounded in
  Round (n, expr c "to")

let simple =
  [
    ("model", always (fun c -> Model (named c))); ("import", always import); ("parameter", always parameter);
    ("timestep", always timestep); ("splitStep", valued (fun e -> Split_step e));
    ("dynamics", setting (fun n -> Dynamics n)); ("collisions", setting (fun n -> Collisions n));
    ("binding", setting (fun n -> Binding n)); ("bonds", setting (fun n -> Bonds n));
    ("blocked", setting (fun n -> Blocked n));
    ("resolution", valued (fun e -> Resolution e)); ("round", always round); ("shape", always shape);
    ("compound", always compound); ("decomposed", always decomposed); ("behaviour", always behaviour);
    ("process", process); ("fixed", fixed);
    ("bond", always (fun c -> Bond (bond c))); ("network", always network); ("motion", motion);
    ("let", always (fun c -> let n = named c in Let (n, expr c "value")));
    ("check", always (fun c -> let n = named c in Check (n, Content.content c Content.expression)));
  ]

let tags = "for" :: List.map fst simple

let rec item report (e : Document.element) =
  let read =
    if String.equal e.tag "for" then Some loop else List.assoc_opt e.tag simple
  in
  match read with
  | None ->
    Content.error report Code.xml_unexpected e.at ?hint:(Diag.suggest e.tag tags) "`<%s>` is no declaration" e.tag;
    None
  | Some read ->
    let c = Content.of_element report e in
    let kind = read c in
    Content.finish c;
    Option.map (fun it -> { it; at = e.whole }) kind

and loop c =
  let over = ranges c in
  (match over with [] -> Content.missing c "a `<range>` is missing here" | _ :: _ -> ());
  let rec items acc =
    match Content.take c with
    | None -> List.rev acc
    | Some e -> items (match item (Content.reports c) e with Some i -> i :: acc | None -> acc)
  in
  Some (For (over, items []))

(* {1 Documents} *)

let check_root report (root : Document.element) =
  if not (String.equal root.tag "bioshape") then
    Content.error report Code.xml_unexpected root.at "a model is a `<bioshape>`, and not a `<%s>`" root.tag;
  Content.finish (Content.of_element report { root with children = [] })

let nothing report items (root : Document.element) =
  match (items, Content.faults report) with
  | [], [] ->
    [ Diag.error Code.empty_model root.at "this model declares nothing"
        ~hint:"a model declares at least one `<process>`" ]
  | _ -> []

(* The declarations that could be read, the comments, and what is wrong. *)
let all source =
  let report = Content.report () in
  let items = ref [] in
  let each e = Option.iter (fun i -> items := i :: !items) (item report e) in
  let trivia, broken =
    match Document.read ~namespace:Namespace.uri ~each source with
    | Ok { root; trivia } -> (
        match check_root report root with
        | () -> (trivia, nothing report !items root)
        | exception Document.Stop -> (trivia, []))
    | Error d -> ([], [ d ])
    | exception Document.Stop -> ([], [])
  in
  (List.rev !items, trivia, List.sort_uniq Diag.compare (broken @ Content.faults report))

let with_trivia source =
  match all source with
  | items, trivia, [] -> Ok (items, trivia)
  | _, _, faults -> Error faults

let readable source =
  let items, _, _ = all source in
  items

let begins text =
  let rec from i =
    i < String.length text
    && match text.[i] with ' ' | '\t' | '\r' | '\n' -> from (i + 1) | c -> c = '<'
  in
  from (Source.after_mark text)
