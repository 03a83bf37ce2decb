type t = { number : int array; count : int }

type search = {
  number : int array;
  index : int array;  (** order of discovery, -1 before *)
  low : int array;
  mutable found : int;
  mutable closed : int;
  mutable stack : int list;  (** nodes whose component is not closed yet *)
}

let discover s v =
  s.index.(v) <- s.found;
  s.low.(v) <- s.found;
  s.found <- s.found + 1;
  s.stack <- v :: s.stack

let rec close s v = function
  | [] -> Scc_base.Bug.fail __POS__ "the stack of the search ran out"
  | w :: rest ->
    s.number.(w) <- s.closed;
    if Int.equal v w then begin
      s.stack <- rest;
      s.closed <- s.closed + 1
    end
    else close s v rest

(* [calls] holds the nodes being visited with the successors still to look at. *)
let rec visit s successors = function
  | [] -> ()
  | (v, w :: later) :: calls ->
    if s.index.(w) < 0 then begin
      discover s w;
      visit s successors ((w, successors w) :: (v, later) :: calls)
    end
    else begin
      if s.number.(w) < 0 then s.low.(v) <- Int.min s.low.(v) s.index.(w);
      visit s successors ((v, later) :: calls)
    end
  | (v, []) :: calls ->
    if s.low.(v) = s.index.(v) then close s v s.stack;
    (match calls with
     | (parent, _) :: _ -> s.low.(parent) <- Int.min s.low.(parent) s.low.(v)
     | [] -> ());
    visit s successors calls

let compute ~size ~roots ~successors =
  let s =
    { number = Array.make size (-1); index = Array.make size (-1); low = Array.make size 0;
      found = 0; closed = 0; stack = [] }
  in
  let start v =
    if s.index.(v) < 0 then begin
      discover s v;
      visit s successors [ (v, successors v) ]
    end
  in
  List.iter start roots;
  ({ number = s.number; count = s.closed } : t)

let members (c : t) =
  let lists = Array.make c.count [] in
  for v = Array.length c.number - 1 downto 0 do
    let k = c.number.(v) in
    if k >= 0 then lists.(k) <- v :: lists.(k)
  done;
  lists

let path ~successors ~from ~goal =
  let reached = Hashtbl.create 64 in
  let queue = Queue.create () in
  let rec back v acc =
    match Hashtbl.find reached v with
    | None -> acc
    | Some (u, step) -> back u ((u, step) :: acc)
  in
  let enter v by =
    if not (Hashtbl.mem reached v) then begin
      Hashtbl.add reached v by;
      Queue.push v queue
    end
  in
  enter from None;
  let rec go () =
    match Queue.take_opt queue with
    | None -> None
    | Some v when goal v -> Some (back v [])
    | Some v ->
      List.iter (fun (w, step) -> enter w (Some (v, step))) (successors v);
      go ()
  in
  go ()
