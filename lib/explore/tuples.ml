(* Nodes of the tree are numbered from the slots, 0 to width - 1, upwards; the root is the last. Node k has the
   children [left.(k)] and [right.(k)], of smaller numbers. *)
type t = {
  width : int;
  left : int array;
  right : int array;
  inner : Pairs.t;
  roots : Pairs.t;
  work : int array;  (** of {!intern} *)
}

type spread = { count : int; node : int array }

(* Neighbours are paired level by level, and an odd one is passed on. *)
let shape width =
  let left = Array.make ((2 * width) - 1) (-1) and right = Array.make ((2 * width) - 1) (-1) in
  let rec level next nodes =
    match nodes with
    | [] | [ _ ] -> ()
    | _ ->
      let rec pair next acc = function
        | a :: b :: rest ->
          left.(next) <- a;
          right.(next) <- b;
          pair (next + 1) (next :: acc) rest
        | [ a ] -> (next, List.rev (a :: acc))
        | [] -> (next, List.rev acc)
      in
      let next, above = pair next [] nodes in
      level next above
  in
  level width (List.init width Fun.id);
  (left, right)

let create ~width =
  if width < 1 then Scc_base.Bug.fail __POS__ "a tuple of no numbers";
  let left, right = shape width in
  {
    width; left; right;
    inner = Pairs.create ();
    roots = Pairs.create ();
    work = Array.make ((2 * width) - 1) 0;
  }

let width t = t.width
let size t = Pairs.size t.roots
let spread t = { count = t.width; node = Array.make ((2 * t.width) - 1) (-1) }
let slots s = Array.sub s.node 0 s.count

(* The root is the pair of its children; of a single slot, the slot and nothing. *)
let load t s id =
  let node = s.node in
  if t.width = 1 then node.(0) <- Pairs.left t.roots id
  else begin
    let root = (2 * t.width) - 2 in
    node.(t.left.(root)) <- Pairs.left t.roots id;
    node.(t.right.(root)) <- Pairs.right t.roots id;
    for k = root - 1 downto t.width do
      node.(t.left.(k)) <- Pairs.left t.inner node.(k);
      node.(t.right.(k)) <- Pairs.right t.inner node.(k)
    done
  end

(* The numbers of all parts but the root, into [t.work]; false when [look] knows one of them not. *)
let parts t ~near slots look =
  let work = t.work and known = near.node in
  Array.blit slots 0 work 0 t.width;
  let root = (2 * t.width) - 2 in
  let rec go k =
    k >= root
    ||
    let l = Array.unsafe_get t.left k and r = Array.unsafe_get t.right k in
    let a = Array.unsafe_get work l and b = Array.unsafe_get work r in
    let id =
      if a = Array.unsafe_get known l && b = Array.unsafe_get known r then Array.unsafe_get known k
      else look t.inner a b
    in
    Array.unsafe_set work k id;
    id >= 0 && go (k + 1)
  in
  go t.width

let root t look =
  if t.width = 1 then look t.roots t.work.(0) 0
  else
    let root = (2 * t.width) - 2 in
    look t.roots t.work.(t.left.(root)) t.work.(t.right.(root))

let check t slots =
  if Array.length slots <> t.width then Scc_base.Bug.fail __POS__ "a tuple of another width"

let intern t ~near slots =
  check t slots;
  ignore (parts t ~near slots Pairs.intern);
  root t Pairs.intern

let find t ~near slots =
  check t slots;
  if parts t ~near slots Pairs.find then root t Pairs.find else -1

let bytes t = Pairs.bytes t.inner + Pairs.bytes t.roots
