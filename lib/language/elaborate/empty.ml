open Scc_syntax

module Names = Set.Make (String)

type t = { mentioned : Names.t; channels : Names.t }

let mentions t name = Names.mem name t.mentioned
let channels t = Names.elements t.channels

(* {1 What a part says itself, without those below} *)

let of_path (p : Ast.path) = List.map (fun (s : Ast.segment) -> s.name.it) p.it
let of_reference (r : Ast.reference) = [ r.target.it ]

let names : Limits.node -> string list = function
  | Expr { it = Path p; _ } -> of_path p
  | Expr { it = Apply (f, _) | Apply_in (_, f, _); _ } -> [ f.it ]
  | Solid { it = Template r; _ } | Behaviour { it = Name r; _ } -> of_reference r
  | Item { it = Behaviour (_, Some on, _, _); _ } -> of_reference on
  | Expr _ | Solid _ | Behaviour _ | Item _ -> []

let bound (b : Ast.bond) = b.bond.it

(* An argument of a behaviour may be a channel. *)
let argument (e : Ast.expr) = match e.it with Path { it = [ { name; indices = [] } ]; _ } -> [ name.it ] | _ -> []

let channels_of : Limits.node -> string list = function
  | Behaviour { it = Open (c, _) | Weak (c, _, _); _ } -> [ c.channel.it ]
  | Behaviour { it = Strong (cs, _, _); _ } -> List.map (fun (c : Ast.channel) -> c.channel.it) cs
  | Behaviour { it = Name r; _ } -> List.concat_map argument r.arguments
  | Item { it = Bond b; _ } -> [ bound b ]
  | Item { it = Process (_, _, rest) | Fixed (_, _, rest); _ } -> List.map (fun (b, _) -> bound b) rest
  | Expr _ | Solid _ | Behaviour _ | Item _ -> []

(* Of all parts below some. *)
let rec gather what found = function
  | [] -> found
  | node :: rest ->
    let found = List.fold_left (fun found name -> Names.add name found) found (what node) in
    gather what found (List.rev_append (Limits.children node) rest)

let within what nodes = gather what Names.empty nodes

(* {1 Where it begins} *)

let variables : Limits.node -> string list = function
  | Expr { it = Quantified (_, v, _, _); _ } -> [ v.it ]
  | Item { it = Motion (_, { it = Choose kicks; _ }); _ } ->
    List.concat_map (fun (k : Ast.kick) -> List.map (fun (r : Ast.range) -> r.index.it) k.over) kicks
  | Expr _ | Solid _ | Behaviour _ | Item _ -> []

(* Names in what is said of each of some, but for its own variables. *)
let rec repeated found = function
  | [] -> found
  | (node : Limits.node) :: rest -> (
      match node with
      | Expr { it = Quantified _; _ } | Item { it = Motion (Some _, _) | Motion (_, { it = Choose _; _ }); _ } ->
        let own = Names.diff (within names [ node ]) (within variables [ node ]) in
        repeated (Names.union found own) rest
      | _ -> repeated found (List.rev_append (Limits.children node) rest))

(* {1 What that mentions} *)

type declaration = { nodes : Limits.node list; own : Names.t; name : string }

let declaration (i : Ast.item) =
  let of_head (h : Ast.head) =
    let formals = List.map (fun (n : Ast.name) -> n.it) h.formals in
    Some { nodes = [ Item i ]; own = Names.of_list formals; name = h.declared.it }
  in
  match i.it with
  | Behaviour (h, _, _, _) | Shape (h, _, _) | Compound (h, _, _, _) | Decomposed (h, _, _, _) -> of_head h
  | Let (name, _) -> Some { nodes = [ Item i ]; own = Names.empty; name = name.it }
  | _ -> None

let rec all_items found = function
  | [] -> found
  | ({ it = Ast.For (_, items); _ } as i : Ast.item) :: rest -> all_items (i :: found) (List.rev_append items rest)
  | i :: rest -> all_items (i :: found) rest

(* With the names in the declarations of names, and so on. *)
let closed what declarations start =
  let rec go seen found = function
    | [] -> found
    | name :: rest when Names.mem name seen -> go seen found rest
    | name :: rest ->
      let add (found, more) d =
        let below = Names.diff (within names d.nodes) d.own in
        (Names.union found (Names.diff (within what d.nodes) d.own), Names.elements below @ more)
      in
      let found, more = List.fold_left add (found, []) (Hashtbl.find_all declarations name) in
      go (Names.add name seen) found (List.rev_append more rest)
  in
  go Names.empty Names.empty (Names.elements start)

let make model ~reached =
  let items = all_items [] model in
  let declarations : (string, declaration) Hashtbl.t = Hashtbl.create 64 in
  List.iter (fun (d : declaration) -> Hashtbl.add declarations d.name d) (List.filter_map declaration items);
  let is_idle (i : Ast.item) = match i.it with For _ -> not (reached i.at.start) | _ -> false in
  let idle = List.map (fun i -> Limits.Item i) (List.filter is_idle items) in
  let in_idle = within names idle in
  let start = Names.union in_idle (repeated Names.empty (List.map (fun i -> Limits.Item i) model)) in
  {
    mentioned = Names.union start (closed names declarations start);
    channels = Names.union (within channels_of idle) (closed channels_of declarations in_idle);
  }
