/* Serial ports of Linux. A page has none, so programs learn that when they open one. */
#ifndef SITEGEN_LINUX_SERIAL_H_
#define SITEGEN_LINUX_SERIAL_H_

#include <linux/types.h>

struct serial_struct
{
  int type;
  int line;
  unsigned int port;
  int irq;
  int flags;
  int xmit_fifo_size;
  int custom_divisor;
  int baud_base;
  unsigned short close_delay;
  char io_type;
  char reserved_char[1];
  int hub6;
  unsigned short closing_wait;
  unsigned short closing_wait2;
  unsigned char * iomem_base;
  unsigned short iomem_reg_shift;
  unsigned int port_high;
  unsigned long iomap_base;
};

struct serial_icounter_struct
{
  int cts, dsr, rng, dcd;
  int rx, tx;
  int frame, overrun, parity, brk;
  int buf_overrun;
  int reserved[9];
};

struct serial_rs485
{
  __u32 flags;
  __u32 delay_rts_before_send;
  __u32 delay_rts_after_send;
  __u32 padding[5];
};

#define ASYNC_CLOSING_WAIT_INF 0
#define ASYNC_CLOSING_WAIT_NONE 65535

#define ASYNC_SPD_HI 0x0010
#define ASYNC_SPD_VHI 0x0020
#define ASYNC_SKIP_TEST 0x0040
#define ASYNC_SPD_CUST 0x0030
#define ASYNC_SPD_SHI 0x1000
#define ASYNC_SPD_WARP 0x1010
#define ASYNC_SPD_MASK 0x1030
#define ASYNC_LOW_LATENCY 0x2000

#define SER_RS485_ENABLED (1 << 0)
#define SER_RS485_RTS_ON_SEND (1 << 1)
#define SER_RS485_RTS_AFTER_SEND (1 << 2)
#define SER_RS485_RX_DURING_TX (1 << 4)
#define SER_RS485_TERMINATE_BUS (1 << 5)

#endif
