open Scc_base
open Scc_syntax

exception Fault of Diag.t

let ok = function Ok x -> x | Error d -> raise (Fault d)

let channel (c : Ast.channel) =
  { c with features = [ { Ast.feature = Tree.feature (ok (Region.of_members c.span c.features)); only = false
                        } ] }

let feature f = Tree.feature (ok (Region.of_feature f))

let apply span f arguments : Ast.expr = Tree.at span (Ast.Apply (Tree.at span f, arguments))

(* The regions that the vertices and faces of a template are. *)
let regions (head : Ast.head) vertices faces =
  let places = Hashtbl.create 16 in
  List.iter (fun ((n : Ast.name), v) -> Hashtbl.replace places n.it v) vertices;
  let region (n : Ast.name) x = Tree.at n.at (Tree.item (Region (n, head.declared, x))) in
  let point ((n : Ast.name), v) = region n (apply n.at "point" [ v ]) in
  let corner (n : Ast.name) =
    match Hashtbl.find_opt places n.it with
    | Some v -> v
    | None -> raise (Fault (Diag.error Code.unknown_feature n.at "there is no vertex `%s`" n.it))
  in
  let face ((n : Ast.name), corners) = region n (apply n.at "polygon" (List.map corner corners)) in
  List.append (List.map point vertices) (List.map face faces)

let rec item (i : Ast.item) =
  match i.it with
  | Shape (head, { it = Faces (vertices, faces); at }, definitions) ->
    let target = Tree.at at "polyhedron" in
    let arguments = List.map snd vertices in
    let solid = Tree.at at (Ast.Template { qualifier = None; target; indices = []; arguments }) in
    { i with it = Ast.Shape (head, solid, definitions) } :: regions head vertices faces
  | For (ranges, body) -> [ { i with it = Ast.For (ranges, List.concat (List.map item body)) } ]
  | _ -> [ Walk.item { Walk.same with channel; feature } i ]

let model items =
  match List.concat (List.map item items) with
  | items -> Ok items
  | exception Fault d -> Error [ d ]
