module Make (Key : Hashtbl.HashedType) = struct
  module Table = Hashtbl.Make (Key)

  (* The last key first. *)
  type t = { numbers : int Table.t; mutable keys : Key.t list }

  let create () = { numbers = Table.create 64; keys = [] }
  let size t = Table.length t.numbers

  let number t key =
    match Table.find_opt t.numbers key with
    | Some i -> i
    | None ->
      let i = size t in
      Table.add t.numbers key i;
      t.keys <- key :: t.keys;
      i

  let keys t = List.rev t.keys
end
