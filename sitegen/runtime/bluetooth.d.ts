// Web Bluetooth as far as it is used here; TypeScript's libraries do not know it.
interface Navigator {
  readonly bluetooth?: {
    requestDevice(options: { filters: { services: string[] }[] }): Promise<BluetoothDevice>;
  };
}
interface BluetoothDevice extends EventTarget {
  readonly name?: string;
  readonly gatt: {
    readonly connected: boolean;
    connect(): Promise<BluetoothServer>;
    disconnect(): void;
  };
}
interface BluetoothServer {
  getPrimaryService(service: string): Promise<{
    getCharacteristic(characteristic: string): Promise<BluetoothCharacteristic>;
  }>;
}
interface BluetoothCharacteristic extends EventTarget {
  readonly value: DataView | null;
  startNotifications(): Promise<unknown>;
  writeValueWithoutResponse(value: BufferSource): Promise<void>;
}
