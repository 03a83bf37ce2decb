open Scc_syntax

type t = (string, Ast.solid list) Hashtbl.t

(* More solids than this tell nothing about the features of one. *)
let most = 8

let key (s : Ast.solid) =
  match s.it with
  | Template { qualifier = None; target; arguments = []; _ } -> target.it
  | _ -> string_of_int s.at.start

(* The behaviours that a behaviour leads to, in what is written of it. *)
let mentioned (b : Ast.behaviour) =
  let rec collect found = function
    | [] -> found
    | (b : Ast.behaviour) :: rest -> (
        match b.it with
        | Nil -> collect found rest
        | Open (_, b) | Weak (_, _, b) | Strong (_, _, b) | Delay (_, b) -> collect found (b :: rest)
        | Sum (a, b) -> collect found (a :: b :: rest)
        | Name { qualifier = None; target; _ } -> collect (target.it :: found) rest
        | Name { qualifier = Some _; _ } -> collect found rest)
  in
  collect [] [ b ]

let solids (t : t) name = Option.value ~default:[] (Hashtbl.find_opt t name)

let iter t f = Hashtbl.iter f t

let of_model (model : Ast.model) =
  let t : t = Hashtbl.create 64 and leads = Hashtbl.create 64 in
  let rec spread = function
    | [] -> ()
    | (name, solid) :: rest ->
      let known = solids t name in
      let is_known = List.exists (fun s -> String.equal (key s) (key solid)) known in
      if is_known || List.length known >= most then spread rest
      else begin
        Hashtbl.replace t name (known @ [ solid ]);
        let next = List.map (fun n -> (n, solid)) (Hashtbl.find_all leads name |> List.concat) in
        spread (List.rev_append next rest)
      end
  in
  let leaf (l : Ast.leaf) =
    let names = Option.fold ~none:[] ~some:mentioned l.behaviour in
    spread (List.map (fun name -> (name, l.solid)) names)
  in
  let rec each f (items : Ast.model) =
    List.iter (fun (i : Ast.item) -> match i.it with For (_, items) -> each f items | _ -> f i) items
  in
  each
    (fun i -> match i.it with Behaviour (h, _, b, _) -> Hashtbl.add leads h.declared.it (mentioned b) | _ -> ())
    model;
  each
    (fun i ->
       match i.it with
       | Process (_, one, rest) | Fixed (_, one, rest) ->
         leaf one;
         List.iter (fun (_, l) -> leaf l) rest
       | _ -> ())
    model;
  t
