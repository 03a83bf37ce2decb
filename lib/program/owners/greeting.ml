type self = { number : int; count : int; program : string; identity : string; secret : string }

(* The first bytes on a connection: a mark with the version of this protocol, who speaks, of how many, a digest
   of the program, a digest of the exploration, and a nonce. *)
let mark = "scc owner 1\n"
let digest_size = 32
let hello_size = String.length mark + 4 + (3 * digest_size)

let nonce () =
  match Scc_system.Randomness.bytes digest_size with
  | Ok bytes -> bytes
  | Error why -> Failure.lost "%s" why

let sha text = Sha256.to_bin (Sha256.string text)

let hello self nonce =
  let b = Buffer.create hello_size in
  Buffer.add_string b mark;
  Buffer.add_uint16_le b self.number;
  Buffer.add_uint16_le b self.count;
  List.iter (Buffer.add_string b) [ sha self.program; sha self.identity; nonce ];
  Buffer.contents b

(* HMAC (RFC 2104) with SHA-256, of which a block has 64 bytes. *)
let hmac key text =
  let key = if String.length key > 64 then sha key else key in
  let padded with_ = String.init 64 (fun i ->
      Char.chr ((if i < String.length key then Char.code key.[i] else 0) lxor with_)) in
  sha (padded 0x5c ^ sha (padded 0x36 ^ text))

let equal_digests a b =
  let differ = ref (String.length a lxor String.length b) in
  String.iteri (fun i c -> if i < String.length b then differ := !differ lor (Char.code c lxor Char.code b.[i])) a;
  !differ = 0

(* {1 One connection} *)

type talk = {
  fd : Unix.file_descr;
  expected : int option;  (** who was called; [None] for one who has called *)
  mine : string;
  got : Buffer.t;
  mutable theirs : string option;
}

let write fd text =
  match Unix.write_substring fd text 0 (String.length text) with
  | n when n = String.length text -> ()
  | _ -> Failure.lost "a connection takes no greeting"
  | exception Unix.Unix_error (e, _, _) -> Failure.lost "a connection takes no greeting: %s" (Unix.error_message e)

let talk self ?expected fd =
  Unix.set_nonblock fd;
  Unix.setsockopt fd TCP_NODELAY true;
  let mine = hello self (nonce ()) in
  write fd mine;
  { fd; expected; mine; got = Buffer.create 256; theirs = None }

let part text from = String.sub text (String.length mark + 4 + (from * digest_size)) digest_size
let number text k = String.get_uint16_le text (String.length mark + (2 * k))

let name t =
  match t.expected with
  | Some k -> Printf.sprintf "owner %d" (k + 1)
  | None -> "a process that has called"

let greeted self t ~wanted text =
  let who = name t in
  if not (String.equal (String.sub text 0 (String.length mark)) mark) then
    Failure.refused "%s is no owner of this version of the protocol" who;
  let k = number text 0 in
  let is_expected = Option.fold ~none:true ~some:(fun e -> e = k) t.expected in
  if number text 1 <> self.count || not (wanted k && is_expected) then
    Failure.refused "%s calls itself owner %d of %d, which is not expected here" who (k + 1) (number text 1);
  if not (String.equal (part text 0) (part t.mine 0)) then
    Failure.refused "%s is another version of scc" who;
  if not (String.equal (part text 1) (part t.mine 1)) then
    Failure.refused
      "%s explores something else: another model, other options, or another `run', `order', `states' or \
       `evaluate' in its first line"
      who;
  t.theirs <- Some text;
  write t.fd (hmac self.secret ("proof" ^ t.mine ^ text))

(* Whether the other side has shown who it is. *)
let rec go_on self t ~wanted =
  let have = Buffer.length t.got in
  match t.theirs with
  | None when have >= hello_size ->
    greeted self t ~wanted (Buffer.sub t.got 0 hello_size);
    go_on self t ~wanted
  | Some theirs when have >= hello_size + digest_size ->
    let proof = Buffer.sub t.got hello_size digest_size in
    if not (equal_digests proof (hmac self.secret ("proof" ^ theirs ^ t.mine))) then
      Failure.refused "%s has another secret" (name t);
    true
  | None | Some _ -> false

let hear self t ~wanted =
  (* Not a byte more: what follows are messages. *)
  let want = (match t.theirs with None -> hello_size | Some _ -> hello_size + digest_size) - Buffer.length t.got in
  let bytes = Bytes.create want in
  match Unix.read t.fd bytes 0 want with
  | 0 -> Failure.lost "%s has ended the connection: it has ended, or has another secret" (name t)
  | n ->
    Buffer.add_subbytes t.got bytes 0 n;
    go_on self t ~wanted
  | exception Unix.Unix_error ((EAGAIN | EWOULDBLOCK | EINTR), _, _) -> false
  | exception Unix.Unix_error (e, _, _) -> Failure.lost "%s: %s" (name t) (Unix.error_message e)

let peer t = match t.theirs with Some text -> number text 0 | None -> Scc_base.Bug.fail __POS__ "nobody has come"
