type t = {
  number : int;
  count : int;
  links : Link.t option array;
  parts : string Queue.t array;  (** of each owner, what it has said in rounds that have not been gathered *)
  partial : Buffer.t array;  (** of each owner, the beginning of what it says *)
  each : int -> char -> string -> unit;
  from_parent : unit -> unit;
  mutable lets_go : bool;
  mutable messages : int;
  mutable bytes : int;
}

let make ~number ~links ~each ~from_parent =
  let count = Array.length links in
  {
    number; count; links; each; from_parent;
    parts = Array.init count (fun _ -> Queue.create ());
    partial = Array.init count (fun _ -> Buffer.create 64);
    lets_go = false;
    messages = 0;
    bytes = 0;
  }

let number m = m.number
let count m = m.count
let messages m = m.messages
let bytes m = m.bytes

(* Kinds of messages that are for the mesh itself: a piece of what is said in a round, and the last piece. *)
let piece = 'p'
let last_piece = 'P'

let is_own c = Char.equal c piece || Char.equal c last_piece

let heard m peer kind text =
  if is_own kind then begin
    Buffer.add_string m.partial.(peer) text;
    if Char.equal kind last_piece then begin
      Queue.push (Buffer.contents m.partial.(peer)) m.parts.(peer);
      Buffer.clear m.partial.(peer)
    end
  end
  else m.each peer kind text

let let_go m = m.lets_go <- true
let all m = List.filter_map Fun.id (Array.to_list m.links)

(* What has come is worked on, and what waits is written; once. *)
let pump m seconds =
  let links = all m in
  let reads = Unix.stdin :: List.map Link.descriptor links in
  let writes = List.filter_map (fun l -> if Link.waiting l > 0 then Some (Link.descriptor l) else None) links in
  match Unix.select reads writes [] seconds with
  | [], [], _ -> ()
  | readable, writable, _ ->
    let work l =
      if List.memq (Link.descriptor l) writable then Link.flush l;
      if List.memq (Link.descriptor l) readable then Link.receive l (heard m (Link.peer l))
    in
    let each l = try work l with Failure.Failed (Lost _) when m.lets_go -> m.links.(Link.peer l) <- None in
    List.iter each links;
    if List.memq Unix.stdin readable then m.from_parent ()
  | exception Unix.Unix_error (EINTR, _, _) -> ()

let post m peer kind text =
  m.messages <- m.messages + 1;
  m.bytes <- m.bytes + 5 + String.length text;
  Option.iter (fun l -> Link.post l kind text) m.links.(peer)

let waiting m peer = Option.fold ~none:0 ~some:Link.waiting m.links.(peer)

(* More than this waits for nobody. *)
let much = 4 * Link.most

let send m peer kind text =
  post m peer kind text;
  while waiting m peer > much do pump m (-1.) done

let say m peer text =
  let n = String.length text in
  let rec from at =
    if n - at > Link.most then begin
      send m peer piece (String.sub text at Link.most);
      from (at + Link.most)
    end
    else send m peer last_piece (String.sub text at (n - at))
  in
  from 0

let others m = List.filter (fun k -> k <> m.number) (List.init m.count Fun.id)

let gather m text =
  List.iter (fun peer -> say m peer (text peer)) (others m);
  let is_missing peer = Queue.is_empty m.parts.(peer) in
  while List.exists is_missing (others m) do pump m (-1.) done;
  Array.init m.count (fun peer -> if peer = m.number then text peer else Queue.pop m.parts.(peer))

let sums m numbers =
  let b = Buffer.create 16 in
  List.iter (Scc_codec.Packed.put_nat b) numbers;
  let mine = Buffer.contents b in
  let add sums text =
    let source = Scc_codec.Packed.source text in
    match List.map (fun n -> n + Scc_codec.Packed.nat source) sums with
    | sums -> sums
    | exception Scc_codec.Packed.Malformed what -> Failure.refused "an owner: %s" what
  in
  Array.fold_left add (List.map (fun _ -> 0) numbers) (gather m (fun _ -> mine))
